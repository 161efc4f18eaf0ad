%(expect: nc-flow-label 4 1 dialect: fanuc)
O0001
G90 G0 X1.
GOTO 20
M30
%
N20 X2.
M30
%
