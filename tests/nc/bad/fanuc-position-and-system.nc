(expect: nc-axes-twice 4 1 dialect: fanuc)
G21 G17 G90 G94 G54
G0 X0. Y0. Z20.
G55 G92 X0. Y0. Z0.
