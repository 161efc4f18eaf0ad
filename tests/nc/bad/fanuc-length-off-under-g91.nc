(expect: nc-not-interpreted 4 5 dialect: fanuc)
G90 G10 L2 P1 Z0
G43 H0 G0 Z5.
G91 G43.4 H0 G1 Z-1. F100
