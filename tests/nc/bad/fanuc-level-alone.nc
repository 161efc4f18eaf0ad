(expect: nc-word-unused 4 1 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G98 G81 X10. Y5. Z-5. R2. F100.
R3.
X20.
M30
