(expect: nc-not-interpreted 4 9 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G86 X5. Z-3. R1. F100.
Y5. M98 P7 L2
M30
O7
M99
