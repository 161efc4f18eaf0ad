(expect: nc-not-interpreted 5 4 dialect: fanuc)
G65 P2 L3 A10.
M30
O2
#2=#2+1
G0 X[#1+#2]
M99
