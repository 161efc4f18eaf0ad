(expect: nc-word-unused 4 31 dialect: fanuc)
G21 G90 G54 G17
G0 X0. Y0. Z20.
G98 G73 X0. Y0. Z-12. R2. Q3. J0.5 F100.
G80
M30
