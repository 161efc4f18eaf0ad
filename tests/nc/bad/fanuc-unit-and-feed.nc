(expect: nc-not-interpreted 2 5 dialect: fanuc)
G20 F10.
