(expect: nc-not-interpreted 6 1 dialect: fanuc)
G65 P2 L2 A1.
N7 M30
O2
G0 X#1
M99 P7
