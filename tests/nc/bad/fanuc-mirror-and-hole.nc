(expect: nc-axes-twice 4 7 dialect: fanuc)
G21 G17 G90 G94 G54
G0 X0. Y0. Z20.
G50.1 G81 X5. Z5. R12. F100.
