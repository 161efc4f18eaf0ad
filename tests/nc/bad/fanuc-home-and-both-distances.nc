(expect: nc-not-interpreted 3 12 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G91 G28 Z0 G90
