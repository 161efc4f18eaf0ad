(expect: nc-not-interpreted 6 12 dialect: fanuc)
G10 L10 P1 R100.
G90 G54 G0 X0 Y0
G43 H1 Z50.
G91 G28 Z0 (the length ends there)
G90 G0 X5. Z10.
M30
