(expect: nc-not-interpreted 4 4 dialect: fanuc)
G21 G90 G54 G17
G0 X0. Y0. Z20.
#5=#4109
M30
