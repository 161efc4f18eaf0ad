(expect: nc-flow-control 2 1 dialect: fanuc)
WHILE [1 EQ 2] DO 1
DO 2 (AND THIS)
N5 END 1
END 2
