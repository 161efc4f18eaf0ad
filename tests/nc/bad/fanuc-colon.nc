(expect: nc-bad-character 3 4 dialect: fanuc)
O0036
G0 :5
M30
