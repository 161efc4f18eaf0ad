(expect: nc-word-unused 3 13 dialect: fanuc: it turns in space)
G90 G54 G0 X0. Y0. Z50.
G68 X0. Y0. Z0. R30.
M30
