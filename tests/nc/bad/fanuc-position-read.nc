(expect: nc-position-read 3 6 dialect: fanuc)
G90 G0 X1.
#100=#5041
