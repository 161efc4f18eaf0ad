(expect: nc-tilted-plane 4 1 dialect: fanuc)
G90 G54 G0 X0. Y0. Z50. A0. B0. C0.
G68.2 X0. Y0. Z0. I0. J20. K0.
G53.1
M30
