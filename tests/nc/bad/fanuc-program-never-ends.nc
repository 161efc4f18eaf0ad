(expect: nc-flow-open 0 0 dialect: fanuc)
M98 P100
M30
O100
G0 X1.
