(expect: nc-not-interpreted 2 4 dialect: fanuc)
#5=#4001
G21 G90 G54 G17
G0 X0. Y0. Z20.
M30
