(expect: nc-not-whole 3 12 dialect: fanuc)
#1=370.5
G0 X0 C[#1 MOD 360]
