(expect: nc-not-interpreted 2 1 dialect: fanuc)
G66 P100 A1.
