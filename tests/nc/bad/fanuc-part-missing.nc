(expect: nc-flow-label 3 1 dialect: fanuc)
G90 G0 X1.
M97 P77
M30
O2
N77 X2.
M99
