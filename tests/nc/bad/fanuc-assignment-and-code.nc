(expect: nc-flow-control 2 9 dialect: fanuc)
#100=3. M8
