(expect: nc-not-interpreted 6 1 dialect: fanuc)
O1
G90 G54 G0 X0. Y0. Z20.
#1=#1+5.
X#1
M99
