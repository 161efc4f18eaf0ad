(expect: nc-axes-twice 4 10 dialect: fanuc)
G21 G17 G90 G94 G54
G0 X0. Y0. Z20.
G28 Z50. G92 X0.
