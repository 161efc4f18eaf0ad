(expect: nc-not-interpreted 6 1 dialect: fanuc)
O1
G90 G54 G0 X0. Y0. Z20.
G81 X1. Z-5. R2. F100.
G99 X2.
M99
