(expect: nc-not-interpreted 3 27 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G98 G83 X10. Y5. Z-5. R2. Q-1. F100.
M30
