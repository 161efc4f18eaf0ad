(expect: nc-flow-control 2 1 dialect: fanuc)
IF [#1 EQ #0] THEN GOTO 10
N10
