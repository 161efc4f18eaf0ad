(expect: nc-position-read 3 5 dialect: fanuc)
G90 G0 X10. Y10. Z50.
G17 G68 X0 R30.
X20. Y10.
