(expect: nc-flow-control 3 1 dialect: fanuc)
#1=0
WHILE [#1 LT 3] DO 1
WHILE [#1 LT 2] DO 2
#1=#1+1
END 1
END 2
