(expect: nc-not-interpreted 2 4 dialect: fanuc)
G1 G41 D1 X5. F100
