(expect: nc-not-interpreted 3 9 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G90 X5. G91 Y5.
