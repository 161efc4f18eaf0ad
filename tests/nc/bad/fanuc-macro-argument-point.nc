(expect: nc-value-unknown 3 12 dialect: fanuc)
O1
G65 P2 A1. Q5
M30
O2
M99
