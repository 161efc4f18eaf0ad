(expect: nc-not-interpreted 4 1 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G18
G81 X5. Y-20. Z5. R-2. F100.
