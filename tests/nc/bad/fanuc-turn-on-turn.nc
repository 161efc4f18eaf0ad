(expect: nc-not-interpreted 3 1 dialect: fanuc)
G68 X0 Y0 R10.
G68 X0 Y0 R10.
