(expect: nc-value-unknown 3 8 dialect: fanuc)
G20
G1 X1. F10
