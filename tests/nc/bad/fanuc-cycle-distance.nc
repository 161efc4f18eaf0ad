(expect: nc-not-interpreted 4 1 dialect: fanuc)
G0 X0 Y0 Z10.
G91 G81 X1. Z-5. R-8. F100
G90 X2.
