(expect: nc-word-unused 3 13 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G68 X0. Y0. Z5. R30.
X0 Y0
