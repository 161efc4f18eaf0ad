(expect: nc-not-interpreted 3 1 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G19 G82 X5. Y-20. Z5. R-2. P100 F100.
