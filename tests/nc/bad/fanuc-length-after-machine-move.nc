(expect: nc-not-interpreted 7 1 dialect: fanuc)
G10 L10 P1 R100.
G90 G54 G0 X0 Y0
G43.4 H1 Z50.
G53 Z-10.
X5. Y5.
A5.
M30
