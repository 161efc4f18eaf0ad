(expect: nc-not-interpreted 3 10 dialect: fanuc)
#1=1
GOTO 10; X5.
N10 M30
