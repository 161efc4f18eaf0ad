(expect: nc-not-interpreted 3 1 dialect: fanuc)
S500 M3 G95
G4 X2.
