(expect: nc-same-group 4 8 dialect: fanuc)
G21 G17 G90 G94 G54
G0 X0. Y0. Z20.
M98 P9 M30
