(expect: nc-bad-character 3 1 dialect: fanuc: comments may have them)
(a comment in small letters)
g1 X1. F100.
