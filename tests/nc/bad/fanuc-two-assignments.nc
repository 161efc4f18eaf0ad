(expect: nc-flow-control 2 7 dialect: fanuc)
#1=3. #2=4.
