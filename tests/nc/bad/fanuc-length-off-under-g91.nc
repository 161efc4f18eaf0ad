(expect: nc-not-interpreted 5 12 dialect: fanuc)
G10 L10 P1 R50.
G90 G0 Z50.
G43.4 H1 Z5.
G91 G49 G1 Z-1. F100
