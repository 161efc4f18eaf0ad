(expect: nc-parameter-unset 2 4 dialect: fanuc)
#1=#500
