(expect: nc-operator 2 5 dialect: fanuc)
IF [EXISTS[#5] EQ 1] GOTO 9
N9 M30
