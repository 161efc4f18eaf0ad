(expect: nc-not-interpreted 2 4 dialect: fanuc)
#1=#4001
