(expect: nc-not-interpreted 4 7 dialect: fanuc)
G21 G17 G90 G94 G54
G0 X0. Y0. Z20.
G54.1 P1 G84 X5. Z5. R12. F100.
