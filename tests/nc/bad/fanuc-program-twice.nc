(expect: nc-flow-open 3 1 dialect: fanuc)
O1
M98 P2
M30
O2
G0 X1.
M99
O0002
G0 X2.
M99
