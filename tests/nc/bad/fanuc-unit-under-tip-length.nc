(expect: nc-not-interpreted 5 5 dialect: fanuc)
G10 L10 P1 R100.
G90 G54 G0 X0 Y0
G43.4 H1 Z50.
G40 G20 G17
M30
