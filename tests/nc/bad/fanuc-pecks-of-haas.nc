(expect: nc-word-unused 4 27 dialect: fanuc)
G21 G90 G54 G17
G0 X0. Y0. Z20.
G98 G83 X0. Y0. Z-12. R2. I3. J0.5 K1 F100.
G80
M30
