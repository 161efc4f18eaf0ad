(expect: nc-not-interpreted 9 1 dialect: fanuc)
O1
G90 G54 G17 G21
G10 L10 P1 R50.
G0 X0 Y0 Z100.
G43 H1 Z50.
G91 G28 X0 Y0
G90 G0 X1. Y1.
Z30.
M30
