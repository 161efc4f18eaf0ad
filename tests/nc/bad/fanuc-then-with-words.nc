(expect: nc-flow-control 2 19 dialect: fanuc)
IF [#1 EQ 0] THEN X5.
