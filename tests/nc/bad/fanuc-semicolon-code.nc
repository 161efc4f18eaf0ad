(expect: nc-not-interpreted 2 5 dialect: fanuc)
M5 ;M9
