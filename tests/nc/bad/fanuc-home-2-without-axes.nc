(expect: nc-axes-missing 3 5 dialect: fanuc)
G90 G0 X0 Y0 Z50.
G91 G30 P2
