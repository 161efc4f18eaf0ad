(expect: nc-axes-missing 5 1 dialect: fanuc)
G90 G0 X0 Y0 Z50.
G10 L10 P3 R75.
G43 H3 Z50.
G28
