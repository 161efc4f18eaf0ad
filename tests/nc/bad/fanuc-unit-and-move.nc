(expect: nc-not-interpreted 3 4 dialect: fanuc)
G0 X1.
G0 X2. G20
