(expect: nc-not-interpreted 4 4 dialect: fanuc)
G21 G17 G90 G94 G54
G0 X0. Y0. Z20.
G4 P9 M98
