(expect: nc-not-interpreted 2 1 dialect: fanuc)
G8 P1 G0 X1.
