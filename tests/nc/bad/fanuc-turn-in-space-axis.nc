(expect: nc-word-unused 3 9 dialect: fanuc: turns about an axis in space)
G90 G54 G0 X0. Y0. Z50.
G68 X0. J1. R-5.
M30
