(expect: nc-not-interpreted 6 5 dialect: fanuc)
G65 P2 L2 X10.
M30
O2
#1=5.
G0 X#24
#24=#24+#1
M99
