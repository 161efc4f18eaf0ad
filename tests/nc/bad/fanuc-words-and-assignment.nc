(expect: nc-flow-control 2 1 dialect: fanuc)
G0 X5. #1=3.
