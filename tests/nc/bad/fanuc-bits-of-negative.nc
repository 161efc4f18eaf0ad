(expect: nc-negative 2 6 dialect: fanuc)
#1=4 OR -1
