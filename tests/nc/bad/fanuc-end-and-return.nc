(expect: nc-same-group 3 5 dialect: fanuc)
G21 G17 G90 G94 G54
M30 M99
