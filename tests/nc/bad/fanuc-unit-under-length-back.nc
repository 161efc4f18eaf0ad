(expect: nc-not-interpreted 6 1 dialect: fanuc)
G20
G10 L10 P1 R4.
G90 G54 G0 X0 Y0
G44 H1 Z2.
G21
M30
