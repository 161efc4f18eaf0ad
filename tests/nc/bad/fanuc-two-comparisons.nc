(expect: nc-operator 2 20 dialect: fanuc)
IF [#1 EQ 1 AND #2 EQ 2] GOTO 10
N10
