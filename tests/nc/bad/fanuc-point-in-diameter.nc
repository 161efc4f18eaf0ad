(expect: nc-not-whole 4 8 dialect: fanuc)
G21 G90 G54 G17
G0 X0. Y0. Z20.
G1 X5. D0.5 F100.
M30
