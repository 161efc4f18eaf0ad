(expect: nc-value-unknown 3 11 dialect: fanuc)
G21 G90 G17
G68 X0 Y0 R-30
M30
