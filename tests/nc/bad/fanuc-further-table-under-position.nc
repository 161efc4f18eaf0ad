(expect: nc-not-interpreted 6 5 dialect: fanuc)
O1
G10 L20 P3 X1. Y0. Z0. A0. B0. C0.
G90 G54.1 P3 G0 X0. Y0. Z20.
G92 Y7.
G10 L20 P3 Y2.
M30
