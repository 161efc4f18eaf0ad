(expect: nc-word-unused 2 8 dialect: fanuc)
G65 P1 G1 X0
