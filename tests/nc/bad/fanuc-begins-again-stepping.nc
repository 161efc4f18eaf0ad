(expect: nc-not-interpreted 7 1 dialect: fanuc)
O1
G91 G10 L2 P1 X5.
G90 G54 G0 X0. Y0. Z20.
X1.
Z50.
M99
