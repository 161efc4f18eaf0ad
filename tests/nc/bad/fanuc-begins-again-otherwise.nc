(expect: nc-not-interpreted 8 1 dialect: fanuc)
O1
G90 G54 G0 X0. Y0. Z20.
IF [#2 EQ #0] GOTO 5
X9.
N5 #2=1
Y5.
M99
