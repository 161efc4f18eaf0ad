(expect: nc-not-interpreted 4 9 dialect: fanuc)
G90 G54 G0 X0 Y0 Z50.
G1 F100.
G1 X20. ,C5.
