(expect: nc-not-interpreted 5 5 dialect: fanuc)
O1
G90 G54 G0 X0. Y0. Z20.
G92 X7.
G10 L2 P1 X2.
M30
