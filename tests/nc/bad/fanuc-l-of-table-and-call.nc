(expect: nc-not-interpreted 4 5 dialect: fanuc)
G21 G17 G90 G94 G54
G0 X0. Y0. Z20.
G10 L2 P2 X5. M98
