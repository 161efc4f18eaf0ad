(expect: nc-not-interpreted 2 5 dialect: fanuc)
G90 G115 X5.
