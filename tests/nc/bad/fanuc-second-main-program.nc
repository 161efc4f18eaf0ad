(expect: nc-flow-open 5 1 dialect: fanuc)
O1
G0 X1.
M30
O2
G0 X2.
M30
