(expect: nc-parameter-number 2 1 dialect: fanuc)
#10000=1
