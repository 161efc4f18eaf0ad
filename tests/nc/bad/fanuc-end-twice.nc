(expect: nc-same-group 3 4 dialect: fanuc)
G21 G17 G90 G94 G54
M2 M30
