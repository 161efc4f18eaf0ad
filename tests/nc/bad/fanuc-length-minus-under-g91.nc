(expect: nc-not-interpreted 2 8 dialect: fanuc)
G91 G0 G44 H0 Z1.
