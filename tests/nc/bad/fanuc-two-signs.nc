(expect: nc-bad-number 2 6 dialect: fanuc)
G0 X--5.
