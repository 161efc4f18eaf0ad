(expect: nc-out-of-range 3 8 dialect: fanuc)
O1
G65 P2 L0 A1.
M30
O2
M99
