(expect: nc-dialect-ambiguous 3 1 dialect: recognise)
G65 P100 A1.
TRAORI
