(expect: nc-not-interpreted 2 1 dialect: fanuc)
G43.5 H1
