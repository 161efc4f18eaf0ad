(expect: nc-not-interpreted 2 9 dialect: fanuc)
G5.1 Q2 X10. Y0 Z0
