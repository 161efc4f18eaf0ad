(expect: nc-word-unused 5 8 dialect: fanuc)
G21 G90 G54 G17
G0 X0. Y0. Z20.
G91
M98 P2 H5
M30
O2
G0 X1.
N5 X2.
M99
