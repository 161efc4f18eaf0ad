(expect: nc-flow-control 2 1 dialect: fanuc)
DO 4
END 4
