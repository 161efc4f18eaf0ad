(expect: nc-not-interpreted 3 8 dialect: fanuc)
G90 G54 G0 X0 Y0
G4 X1. Y5.
