(expect: nc-not-interpreted 2 9 dialect: fanuc)
G54 M98 P48
O48
M99
