(expect: nc-not-interpreted 4 32 dialect: fanuc)
G21 G90 G54 G17
G0 X0. Y0. Z20.
G99 G83 Z-8. R1. Q2. F100. X1. K3
G80
M30
