(expect: nc-not-interpreted 3 6; dialect: fanuc)
O0001
S100 $0
M30
