(expect: nc-not-interpreted 4 1 dialect: fanuc)
G90 G0 X0 Y0 Z50.
G68 X0 Y0 R30.
G18 G2 X5. Z5. R5. F100
