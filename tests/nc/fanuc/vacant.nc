O0033 (a common variable that was made vacant is known to be so)
G21 G90 G0 X1. Y1. Z1.
#101=5
#102=#0
#103=#3 (not given)
G1 X#101 Y#102 Z#103 F100
#101=#0
G1 X#101 Y7.
IF[#101 EQ #0]GOTO10
G1 X99.
N10 #104=#101+2
G1 X#104
#500=#103
IF[#500 NE #0]GOTO20
G1 Z3.
N20 #[102+0]=8
G1 Y#102
M30
