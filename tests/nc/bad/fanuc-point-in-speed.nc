(expect: nc-not-whole 4 1 dialect: fanuc)
G21 G90 G54 G17
G0 X0. Y0. Z20.
S100. M3
M30
