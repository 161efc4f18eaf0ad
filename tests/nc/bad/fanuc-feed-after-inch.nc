(expect: nc-feed-missing 4 1 dialect: fanuc)
G1 X1. F100
G20
X2.
