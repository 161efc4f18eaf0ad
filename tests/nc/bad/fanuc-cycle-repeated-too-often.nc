(expect: nc-too-many-blocks 4 5; dialect: fanuc)
O0001
F100.
G98 G81 X1. Y1. Z-9. R1. K5000000
M30
