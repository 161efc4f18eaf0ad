(expect: nc-axes-unused 8 1 dialect: fanuc)
(the mode before the cycle was a feed)
O0032
G90 G0 X0 Y0 Z20.
G1 Z10. F100
G98 G81 X10. Z-5. R2. F100
G80
X20.
M30
