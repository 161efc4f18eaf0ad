(expect: nc-not-interpreted 4 5 dialect: fanuc)
G21 G90 G54 G17
G0 X0. Y0. Z20.
G0 X#4120
M30
