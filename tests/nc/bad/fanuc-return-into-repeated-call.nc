(expect: nc-not-interpreted 7 1 dialect: fanuc)
M98 P2 L3
N7 M30
O2
G0 Y1.
N7 G91 X1.
M99 P7
