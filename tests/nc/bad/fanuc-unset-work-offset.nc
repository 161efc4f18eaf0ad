(expect: nc-work-offset-unknown 2 10 dialect: fanuc)
G54.1 P3 G0 X1.
