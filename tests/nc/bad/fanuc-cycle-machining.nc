(expect: nc-not-interpreted 2 5 dialect: fanuc)
G05 P10001
