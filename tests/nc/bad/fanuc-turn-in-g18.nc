(expect: nc-not-interpreted 2 5 dialect: fanuc)
G18 G68 X0 Z0 R10.
