(expect: nc-not-whole 2 1 dialect: fanuc)
T1. M6
G21 G90 G54 G17
G0 X0. Y0. Z20.
M30
