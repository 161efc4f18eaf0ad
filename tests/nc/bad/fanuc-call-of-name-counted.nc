(expect: nc-not-interpreted 2 8 dialect: fanuc)
M98 L2 <SUB1>
