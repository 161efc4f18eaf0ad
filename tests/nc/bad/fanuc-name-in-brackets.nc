(expect: nc-operator 2 9 dialect: fanuc)
G0 G54 X#<WIDTH>
M30
