(expect: nc-flow-open 4 1 dialect: fanuc)
O1
(HEAD)
:2
G0 X1.
M30
