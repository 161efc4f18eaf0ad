(expect: nc-same-group 2 1 dialect: fanuc)
G1 G81 X1. Y1. Z-5. R2. F100
