(expect: nc-out-of-range 4 5 dialect: fanuc)
O1
G90 G54 G0 X0. Y0. Z20.
G30 P-2 Z50.
M30
