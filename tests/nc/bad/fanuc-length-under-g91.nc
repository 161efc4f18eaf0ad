(expect: nc-not-interpreted 4 12 dialect: fanuc)
G10 L10 P1 R50.
G90 G0 Z50.
G91 G43 H1 Z-10.
