(expect: nc-not-interpreted 7 9 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G81 X5. Z-3. R1. F100.
M98 P7
N5 M30
O7
Y5. M99 P5
