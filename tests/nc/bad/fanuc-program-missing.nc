(expect: nc-flow-open 2 1 dialect: fanuc)
M98 P7777
