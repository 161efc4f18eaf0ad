(expect: nc-word-missing 2 1 dialect: fanuc)
G65 A1.
