(expect: nc-not-interpreted 7 1 dialect: fanuc)
O1
G90 G54 G0 X0. Y0. Z20.
G10 L2 P2 X1. Y0. Z0. A0. B0. C0.
G55 X1.
G54 X2.
M99
