(expect: nc-not-interpreted 2 1 dialect: fanuc)
X20. Y10. G65 P1000
M30
O1000
M99
