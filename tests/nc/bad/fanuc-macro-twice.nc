(expect: nc-flow-open 2 1 dialect: fanuc)
G65 P9 A1.
M30
O9
G0 X#1
M99
:9
G0 X2.
M99
