(expect: nc-too-many-blocks 4 1 dialect: fanuc)
WHILE [1 EQ 1] DO 1
G0 X5.
END 1
