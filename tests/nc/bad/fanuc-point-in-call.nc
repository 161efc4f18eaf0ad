(expect: nc-not-whole 4 5 dialect: fanuc)
G21 G90 G54 G17
G0 X0. Y0. Z20.
M98 P2.
M30
