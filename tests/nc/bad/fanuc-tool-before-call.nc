(expect: nc-not-interpreted 2 1 dialect: fanuc)
T1 G65 P1000
M30
O1000
M99
