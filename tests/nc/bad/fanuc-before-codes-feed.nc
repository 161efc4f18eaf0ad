(expect: nc-axes-unused 4 1 dialect: fanuc)
G90 G21 G49
G54 X10. Y20. Z5.
Z-1. F100.
