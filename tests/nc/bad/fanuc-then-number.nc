(expect: nc-flow-control 3 1 dialect: fanuc)
#2=3
IF [[#2 GT 1] AND [#2 LT 5]] THEN
