(expect: nc-not-whole 4 24 dialect: fanuc)
G21 G90 G54 G17
G0 X0. Y0. Z20.
G91 G81 X1. Z-8. R-19. K2. F100.
G80
M30
