(expect: nc-not-interpreted 3 26 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G81 X0 Y0 Z-5. R2. F100. G43 H1
