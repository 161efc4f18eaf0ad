(expect: nc-not-whole 4 5 dialect: fanuc)
G21 G90 G54 G17
G0 X0. Y0. Z20.
G43 H1. Z10.
M30
