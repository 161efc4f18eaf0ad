(expect: nc-not-interpreted 5 5 dialect: fanuc)
G65 P2 L2 X10.
M30
O2
IF [#3 NE #0] GOTO 5
#3=1
N5 G0 X#24
M99
