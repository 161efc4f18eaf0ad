(expect: nc-too-many-blocks 4 1 dialect: fanuc)
N10 G0 X5.
X6.
GOTO 10
