(expect: nc-flow-open 9 1 dialect: fanuc)
O1
G0 X0
M98 P2
M30
O2
G0 X1.
M99
:3 (ANOTHER)
G0 X2.
M02
