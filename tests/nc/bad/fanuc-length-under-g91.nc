(expect: nc-not-interpreted 3 5 dialect: fanuc)
G90 G0 Z50.
G91 G43 H1 Z-10.
