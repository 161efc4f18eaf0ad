(expect: nc-not-whole 4 8 dialect: fanuc)
G21 G90 G54 G17
G0 X0. Y0. Z20.
M98 P2 L2.
M30
