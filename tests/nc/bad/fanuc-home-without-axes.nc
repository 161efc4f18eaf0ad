(expect: nc-axes-missing 3 1 dialect: fanuc)
G90 G0 X0 Y0 Z50.
G28
