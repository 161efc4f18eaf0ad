(expect: nc-bad-number 2 7 dialect: fanuc)
G0 X12 5.
