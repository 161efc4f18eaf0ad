(expect: nc-not-interpreted 5 1 dialect: fanuc)
G20 G54 G95
M3 S500
G0 X0 Y0 Z1. A0 B0 C0
G1 A5. F0.01
