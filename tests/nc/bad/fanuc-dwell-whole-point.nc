(expect: nc-not-whole 2 4 dialect: fanuc)
G4 P2.
