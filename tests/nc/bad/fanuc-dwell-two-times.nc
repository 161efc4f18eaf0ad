(expect: nc-not-interpreted 3 4 dialect: fanuc)
G90 G54 G0 X0 Y0
G0 X5. G4 P500
