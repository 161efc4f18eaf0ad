(expect: nc-not-interpreted 2 4 dialect: fanuc)
G5 P01
