(expect: nc-word-unused 3 16 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G10 L10 P1 R5. Z5.
X0
