(expect: nc-flow-open 2 3 dialect: fanuc)
N1O1
G90 G0 X1.
M30
