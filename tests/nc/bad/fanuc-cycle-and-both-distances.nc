(expect: nc-not-interpreted 3 13 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G91 G81 X5. G90 Z-5. R2. F100.
