(expect: nc-axes-twice 4 15 dialect: fanuc)
G21 G17 G90 G94 G54
G1 X0. Y0. Z20. F500.
G10 L2 P2 X5. G3 I5. J0.
