(expect: nc-operator 2 5 dialect: fanuc)
#1=2**3
M30
