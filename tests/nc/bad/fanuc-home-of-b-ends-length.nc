(expect: nc-not-interpreted 8 4 dialect: fanuc)
O1
G90 G54 G17 G21
G10 L10 P1 R50.
G0 X0 Y0 Z100. B0
G43 H1 Z50.
G28 B0
G1 Z10. F100.
M30
