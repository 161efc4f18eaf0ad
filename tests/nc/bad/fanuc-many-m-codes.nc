(expect: nc-same-group 2 16 dialect: fanuc)
M8 M9 M8 M9 M8 M9
