(expect: nc-not-interpreted 4 1 dialect: fanuc)
G90 G0 X0 Y0 Z50.
G68 X0 Y0 R30.
G55 X5. Y5.
