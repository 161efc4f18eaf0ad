(expect: nc-not-interpreted 6 1 dialect: fanuc)
O1
G90 G54 G0 X0. Y0. Z20.
G92 X7.
X1.
M99
