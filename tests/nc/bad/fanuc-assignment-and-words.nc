(expect: nc-flow-control 2 7 dialect: fanuc)
#1=3. G0 X5.
