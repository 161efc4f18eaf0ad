(expect: nc-flow-control 2 1 dialect: fanuc)
IF #1 GOTO 5
