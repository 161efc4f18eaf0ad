(expect: nc-not-interpreted 3 1 dialect: fanuc)
G21 G94 G90 G54 G0 X0 Y0 Z0
F10. G93 G1 X1.
M30
