(expect: nc-word-twice 2 15 dialect: fanuc)
G2 X1. Y0 I1. I2. F100
