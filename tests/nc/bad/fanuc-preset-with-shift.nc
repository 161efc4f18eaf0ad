(expect: nc-not-interpreted 4 1 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G52 X3.
G92.1 Y0
