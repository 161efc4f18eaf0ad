(expect: nc-call-depth 4 1 dialect: fanuc)
M98 P100
O100
M98 P100
M99
