(expect: nc-axes-twice 4 9 dialect: fanuc)
G21 G17 G90 G94 G54
G1 X0. Y0. Z20. F500.
G4 P500 G3 I5. J0.
