(expect: nc-axes-unused 3 5 dialect: fanuc)
G90 G21 G49 F200.
G54 X10. Y20.
