(expect: nc-not-interpreted 2 7 dialect: fanuc)
X20.; G0 Z50.
