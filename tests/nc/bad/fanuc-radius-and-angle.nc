(expect: nc-bad-character 3 4; dialect: fanuc)
O0001
G1 @5. ^30. F100.
M30
