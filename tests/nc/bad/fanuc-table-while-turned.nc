(expect: nc-not-interpreted 4 1 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G68 X0 Y0 R30.
G10 L2 P1 X5.
