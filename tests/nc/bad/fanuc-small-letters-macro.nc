(expect: nc-bad-character 3 1 dialect: fanuc)
O1
if [#1 EQ 1] GOTO 10
N10 M30
