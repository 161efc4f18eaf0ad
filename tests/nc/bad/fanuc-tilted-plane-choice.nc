(expect: nc-word-unused 4 7 dialect: fanuc: chooses between positions of the rotary axes)
G90 G54 G0 X0. Y0. Z50. A0. B0. C0.
G68.2 X0. Y0. Z0. I0. J10. K0.
G53.1 P1
M30
