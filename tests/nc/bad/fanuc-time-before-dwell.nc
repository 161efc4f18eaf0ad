(expect: nc-not-interpreted 3 1 dialect: fanuc: in inches a distance in front of G4)
G20
X1. G04
M30
