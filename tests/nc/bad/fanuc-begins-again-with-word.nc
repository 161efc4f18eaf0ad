(expect: nc-not-interpreted 5 1 dialect: fanuc)
O1
G90 G54 G0 X#33 Y0. Z20.
M98 P2
M99
O2
#33=4.
M99
