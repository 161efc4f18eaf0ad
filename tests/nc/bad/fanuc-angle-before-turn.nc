(expect: nc-not-interpreted 3 7 dialect: fanuc)
G20 G90 G17
X0 Y0 R30. G68
M30
