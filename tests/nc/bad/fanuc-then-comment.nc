(expect: nc-flow-control 2 5 dialect: fanuc)
N10 IF[#1EQ#0]THEN (TURN)
