(expect: nc-not-interpreted 2 5 dialect: fanuc)
M98 <SUB1>
