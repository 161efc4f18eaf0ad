(expect: nc-not-whole 3 7 dialect: fanuc)
#2=2.6
#1=10 MOD #2
