(expect: nc-not-interpreted 5 1 dialect: fanuc)
O1
G90 G54 X0. Y0. Z20.
G1 X1. F100.
M99
