O1 (P belongs to the call and says no turns of the arc)
G21 G17 G90 G94 G54
G0 X0 Y0 Z0
G2 X10. Y0. R5. F300. M98 P2
G3 X0. I-5. M98 P30002
G2 I5. J0. M97 P100
M30
N100 G1 X1.
M99
O2
G91 G1 Z1.
G90
M99
