(expect: nc-not-interpreted 2 6 dialect: fanuc)
G5.1 Q9
