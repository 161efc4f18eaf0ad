(expect: nc-not-whole 2 8 dialect: fanuc)
#1=1.5 AND 3
