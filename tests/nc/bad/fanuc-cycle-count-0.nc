(expect: nc-not-interpreted 4 33 dialect: fanuc)
O1
G90 G21 G54 G17 G0 X0 Y0 Z50.
G99 G81 X10. Y0. Z-5. R2. F200. K0
G80
M30
