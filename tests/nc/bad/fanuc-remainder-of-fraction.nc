(expect: nc-not-whole 2 9 dialect: fanuc)
#1=10.7 MOD 3
