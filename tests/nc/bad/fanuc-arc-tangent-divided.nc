(expect: nc-not-interpreted 3 4 dialect: fanuc)
O1
#1=ATAN[1]/2
M30
