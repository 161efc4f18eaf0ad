(expect: nc-parameter-read-only 2 1 dialect: fanuc)
#5041=1
