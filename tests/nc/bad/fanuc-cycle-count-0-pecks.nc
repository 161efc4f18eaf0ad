(expect: nc-not-interpreted 4 32 dialect: fanuc)
O1
G90 G21 G54 G17 G0 X0 Y0 Z50.
G98 G83 Y3. Z-5. R2. Q1. F200. L0
G80
M30
