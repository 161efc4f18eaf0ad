(expect: nc-not-interpreted 2 4 dialect: fanuc)
G65<BORE_1> A1.
