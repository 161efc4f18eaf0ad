(expect: nc-word-missing 2 1 dialect: fanuc)
G43 G0 Z5.
