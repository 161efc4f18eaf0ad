(expect: nc-not-whole 3 22 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G89 X5. Y5. Z-5. R2. P500. F100.
