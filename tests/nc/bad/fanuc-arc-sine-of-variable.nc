(expect: nc-not-interpreted 4 5 dialect: fanuc)
#1=3
#2=-1.5
#3=[ASIN[#2/#1]+90]
