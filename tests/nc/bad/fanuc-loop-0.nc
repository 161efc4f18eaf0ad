(expect: nc-flow-control 3 1 dialect: fanuc)
#1=0
WHILE [#1 LT 3] DO 0
#1=#1+1
END 0
