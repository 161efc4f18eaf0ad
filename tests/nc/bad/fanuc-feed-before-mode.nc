(expect: nc-not-interpreted 3 7 dialect: fanuc)
G21 G94 G90 G54 G0 X0 Y0 Z0
G1 X1 F.2 G95
M30
