(expect: nc-flow-label 2 1 dialect: fanuc)
END 1
