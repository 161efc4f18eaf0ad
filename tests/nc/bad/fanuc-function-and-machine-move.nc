(expect: nc-axes-twice 4 9 dialect: fanuc)
G21 G17 G90 G94 G54
G0 X0. Y0. Z20.
G5.1 Q1 G53 Z0.
