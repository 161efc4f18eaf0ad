(expect: nc-not-interpreted 4 12 dialect: fanuc)
G10 L10 P3 R20.
G90 G0 Z50.
G91 G44 H3 Z-1.
