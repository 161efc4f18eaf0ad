(expect: nc-not-interpreted 2 9 dialect: fanuc)
G54 M97 P48
N48
M99
