(expect: nc-not-interpreted 4 13 dialect: fanuc)
G21 G17 G90 G94 G54
G0 X0. Y0. Z20.
G53 X0. Y0. G43 H1 Z30.
