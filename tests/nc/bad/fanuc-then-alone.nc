(expect: nc-flow-control 3 1 dialect: fanuc)
#1=1
IF [#1 EQ 2] THEN
X5.
