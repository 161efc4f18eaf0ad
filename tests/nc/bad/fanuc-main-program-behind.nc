(expect: nc-flow-open 5 1 dialect: fanuc)
O2
G0 X1.
M99
O1
M98 P2
G0 X2.
G1 X3. F100. M30
