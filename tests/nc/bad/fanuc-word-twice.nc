(expect: nc-word-twice 2 8 dialect: fanuc)
G0 X1. X2.
