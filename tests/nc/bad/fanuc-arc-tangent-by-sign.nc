(expect: nc-not-interpreted 3 3 dialect: fanuc)
O1
X[ATAN[1]/-[1]]
M30
