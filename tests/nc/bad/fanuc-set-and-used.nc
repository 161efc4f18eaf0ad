(expect: nc-flow-control 2 7 dialect: fanuc)
#1=5. G0 X#1
