(expect: nc-bad-character 3 4 dialect: fanuc)
O1
X1.y5.
M30
