(expect: nc-flow-open 4 1 dialect: fanuc)
O1
G90 G0 X1.
O2
G1 Y1. F100.
M30
