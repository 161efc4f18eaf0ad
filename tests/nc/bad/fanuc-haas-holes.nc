(expect: nc-not-interpreted 2 10 dialect: fanuc)
G81 Z-1. G70 I5. J15. L12
