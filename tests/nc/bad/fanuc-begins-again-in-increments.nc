(expect: nc-not-interpreted 6 1 dialect: fanuc)
O1
G54 G0 X0. Y0. Z20.
G1 X5. F200.
G91 G28 Z0.
M99
