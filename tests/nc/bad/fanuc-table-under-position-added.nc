(expect: nc-not-interpreted 6 9 dialect: fanuc)
O1
G10 L2 P2 X1. Y0. Z0. A0. B0. C0.
G90 G55 G0 X0. Y0. Z20.
G92 Z7.
G91 G10 L2 P2 X2.
M30
