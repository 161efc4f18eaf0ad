(expect: nc-too-many-blocks 4 1 dialect: fanuc)
N10 #1=5.
G0 X#1
IF [#1 GT 3] GOTO 10
