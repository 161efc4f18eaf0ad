(expect: nc-not-interpreted 2 1 dialect: fanuc)
POPEN
