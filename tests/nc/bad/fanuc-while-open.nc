(expect: nc-flow-open 2 1 dialect: fanuc)
WHILE [0 EQ 1] DO 1
G0 X1.
