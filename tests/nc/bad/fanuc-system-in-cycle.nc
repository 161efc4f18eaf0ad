(expect: nc-not-interpreted 3 5 dialect: fanuc)
G82 X1. Z-1. R2. P100 F100.
G54 P1 X2.
M30
