(expect: nc-not-interpreted 2 5 dialect: fanuc)
G10 L11 P1 R.05
