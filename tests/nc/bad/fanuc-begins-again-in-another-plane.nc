(expect: nc-not-interpreted 6 1 dialect: fanuc)
G21 G90 G54
G0 X0. Y0. Z20.
G18
N9 G0 X5.
M99
