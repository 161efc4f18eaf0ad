(expect: nc-not-interpreted 4 17 dialect: fanuc)
G21 G17 G90 G94 G54
G0 X0. Y0. Z20.
G91 G30 Z0. M98 P2
