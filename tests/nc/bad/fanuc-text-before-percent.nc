(expect: nc-bad-character 3 1 dialect: fanuc)
%
O1
G90 G21 G54 G0 X0 Y0 Z5.
G1 X5. F100.
M30
%
