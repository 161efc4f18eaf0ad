(expect: nc-flow-control 2 1 dialect: fanuc)
WHILE [#1 EQ 0]
END 1
