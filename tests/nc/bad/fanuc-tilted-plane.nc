(expect: nc-not-interpreted 2 1 dialect: fanuc)
G68.2 X0 Y0 Z0 I0 J10. K0
