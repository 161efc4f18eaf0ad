%(expect: nc-flow-open 4 1 dialect: fanuc)
O0001
G90 G0 X1.
M98 P2
M30
%
O0002
X2.
M99
%
