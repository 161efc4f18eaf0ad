(expect: nc-word-unused 3 15 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G10 L2 P1 X1. R30.
X0
