(expect: nc-not-interpreted 5 26 dialect: fanuc)
#1=4
G21 G90 G54 G17
G0 X0. Y0. Z20.
G98 G73 X1. Z-8. R1. Q2. K#1 F100.
G80
M30
