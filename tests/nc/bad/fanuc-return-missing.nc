(expect: nc-flow-label 5 1 dialect: fanuc)
M98 P100
M30
O100
M99 P77
