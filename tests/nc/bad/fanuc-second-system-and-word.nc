(expect: nc-word-unused 2 5 dialect: fanuc)
G55 P1 X2.
M30
