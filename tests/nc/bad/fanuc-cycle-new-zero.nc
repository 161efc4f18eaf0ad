(expect: nc-not-interpreted 5 1 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G81 X0 Y0 Z-5. R2. F100.
G52 Z1.
X5.
