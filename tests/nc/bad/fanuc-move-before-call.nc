(expect: nc-not-interpreted 2 5 dialect: fanuc)
N10 G0 X5. G65 P1000 A1.
M30
O1000
M99
