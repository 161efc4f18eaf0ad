(expect: nc-not-interpreted 2 11 dialect: fanuc)
#1=5. G0 X#1
