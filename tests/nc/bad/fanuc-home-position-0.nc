(expect: nc-out-of-range 4 9 dialect: fanuc)
O1
G90 G54 G0 X0. Y0. Z20.
G91 G30 P0 Z0.
M30
