(expect: nc-not-interpreted 7 1 dialect: fanuc)
M98 P2 L3
G0 X1.
N7 M30
O2
G0 Y1.
M99 P7
