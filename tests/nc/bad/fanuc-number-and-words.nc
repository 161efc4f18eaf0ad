(expect: nc-flow-control 2 7 dialect: fanuc)
O0001 G90 G0 X1.
M30
