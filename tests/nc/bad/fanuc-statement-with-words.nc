(expect: nc-flow-control 2 9 dialect: fanuc)
GOTO 10 X5.
N10
