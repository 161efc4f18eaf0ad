(expect: nc-not-interpreted 2 8 dialect: fanuc)
G54 G4 P48
M30
