(expect: nc-flow-control 2 25 dialect: fanuc)
IF [#1 EQ #0] THEN #2=1 #3=2
