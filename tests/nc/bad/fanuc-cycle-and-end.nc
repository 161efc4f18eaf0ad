(expect: nc-same-group 2 29 dialect: fanuc)
G90 G81 X10. Z-5. R2. F100. G80
