(expect: nc-not-interpreted 5 1 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G10 L10 P1 R5.
G43 H1 Z50.
G92.1 Z0
