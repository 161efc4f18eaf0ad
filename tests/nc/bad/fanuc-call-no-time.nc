(expect: nc-out-of-range 3 11 dialect: fanuc)
O1
M98 P0002 L0
M30
O2
M99
