(expect: nc-not-interpreted 2 5 dialect: fanuc)
N10 DPRNT[X#1[33]]
