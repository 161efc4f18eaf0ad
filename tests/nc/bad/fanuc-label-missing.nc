(expect: nc-flow-label 3 1 dialect: fanuc)
G90
GOTO 20
