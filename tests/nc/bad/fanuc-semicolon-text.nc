(expect: nc-not-interpreted 2 14 dialect: fanuc)
G0 X1. (a) ; spindle up
