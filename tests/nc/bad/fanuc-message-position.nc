(expect: nc-position-unknown 5 1 dialect: fanuc)
G21 G90 G17 G54
G0 X1. Y1. Z1. A0 B0 C0
#3006=1(MOVE THE AXES BY HAND)
G2 X3. Y1. I1. F100.
