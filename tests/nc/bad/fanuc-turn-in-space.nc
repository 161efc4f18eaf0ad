(expect: nc-word-unused 3 13 dialect: fanuc: turns about an axis in space)
G90 G54 G0 X0. Y0. Z50.
G68 X0. Y0. I0. J0. K1. R30.
X1. Y1.
M30
