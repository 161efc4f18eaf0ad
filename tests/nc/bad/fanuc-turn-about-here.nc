(expect: nc-position-read 3 1 dialect: fanuc)
G90 G0 X10. Y10. Z50.
G68 R30.
X20. Y10.
