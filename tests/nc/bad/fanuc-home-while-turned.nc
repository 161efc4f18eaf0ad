(expect: nc-not-interpreted 4 5 dialect: fanuc)
G90 G0 X0 Y0 Z50.
G68 X0 Y0 R30.
G91 G28 Z0
