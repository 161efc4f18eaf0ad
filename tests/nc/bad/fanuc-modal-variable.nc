(expect: nc-not-interpreted 3 4 dialect: fanuc)
G90 G0 X1.
#1=#4107
M30
