(expect: nc-bracket-open 2 11 dialect: fanuc)
#1=[#2+1]*[3
