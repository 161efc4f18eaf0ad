(expect: nc-not-interpreted 2 8 dialect: fanuc)
G10 L2 P0 X1.
