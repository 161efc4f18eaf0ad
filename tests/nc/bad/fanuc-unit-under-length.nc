(expect: nc-not-interpreted 5 1 dialect: fanuc)
G10 L10 P1 R100.
G21 G90 G54 G0 X0 Y0
G43 H1 Z50.
G20
Z2.
M30
