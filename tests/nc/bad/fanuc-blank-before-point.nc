(expect: nc-bad-number 3 6 dialect: fanuc)
G90 G54
G1 X5 .5 F100.
