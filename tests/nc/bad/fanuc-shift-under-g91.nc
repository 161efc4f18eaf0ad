(expect: nc-not-interpreted 3 5 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G91 G52 X5. Y5.
G90 X0
