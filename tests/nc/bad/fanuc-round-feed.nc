(expect: nc-not-interpreted 3 11 dialect: fanuc)
G90 G0 X0 Y0 Z0
G1 X10. F[ROUND[333.4]]
