(expect: nc-not-interpreted 2 1 dialect: fanuc)
G13 Z-0.3 I0.1875 K0.2 Q0.1875 D02 F10.0
