(expect: nc-not-interpreted 4 5 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G82 X5. Z-3. R1. P100 F100.
M98 P7 X10.
M30
O7
M99
