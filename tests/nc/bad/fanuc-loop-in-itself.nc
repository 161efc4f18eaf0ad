(expect: nc-flow-control 3 4 dialect: fanuc)
#1=0
N1 WHILE [#1 LT 3] DO 1 (OUTER])
WHILE[#1LT2]DO1
#1=#1+1
END 1
END 1
