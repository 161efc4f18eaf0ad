(expect: nc-not-interpreted 3 1 dialect: fanuc)
G18
G68 X0 Z0 R10.
