(expect: nc-flow-open 5 1 dialect: fanuc)
M98 P100
M30
O100
O200
M99
