(expect: nc-out-of-range 2 8 dialect: fanuc)
G10 L2 P7 X1.
