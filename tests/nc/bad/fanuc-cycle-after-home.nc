(expect: nc-not-interpreted 6 1 dialect: fanuc)
G10 L10 P1 R100.
G90 G54 G0 X0 Y0
G43 H1 Z50.
G81 Z-2. R2. F100.
G91 G30 Z0
G90 X10. (drills along Z)
M30
