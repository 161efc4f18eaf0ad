(expect: nc-not-interpreted 2 1 dialect: fanuc)
G31 Z-5. F100
