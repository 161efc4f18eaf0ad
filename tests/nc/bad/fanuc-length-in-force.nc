(expect: nc-not-interpreted 4 5 dialect: fanuc)
G10 L10 P1 R5.
G43 H1
G10 L10 P1 R6.
