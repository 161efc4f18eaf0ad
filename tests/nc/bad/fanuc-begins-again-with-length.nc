(expect: nc-not-interpreted 6 1 dialect: fanuc)
O1
G10 L10 P1 R100.
G90 G54 G0 X0. Y0. Z120.
G43 H1 Z20.
M99
