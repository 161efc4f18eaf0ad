(expect: nc-bad-number 3 3 dialect: fanuc)
G90 G54 G0 X1. Y1. Z50.
G0 15.
