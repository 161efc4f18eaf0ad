(expect: nc-machine-move 2 5 dialect: fanuc)
G53 G1 Z10. F100
