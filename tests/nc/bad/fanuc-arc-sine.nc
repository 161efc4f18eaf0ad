(expect: nc-not-interpreted 2 6 dialect: fanuc)
G0 X[ASIN[-0.5]]
