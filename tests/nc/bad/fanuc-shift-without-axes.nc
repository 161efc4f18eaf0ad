(expect: nc-axes-missing 2 1 dialect: fanuc)
G52
G90 G0 X0
