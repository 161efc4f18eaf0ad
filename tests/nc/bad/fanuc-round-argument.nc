(expect: nc-not-interpreted 3 12 dialect: fanuc)
#1=2.5
G65 P100 A[ROUND[#1]]
M30
O100
M99
