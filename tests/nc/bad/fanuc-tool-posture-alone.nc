(expect: nc-not-interpreted 4 7 dialect: fanuc)
G21 G17 G90 G94 G54
G0 X0. Y0. Z20.
G43.4 P1 H1
