(expect: nc-tool-vector 3 10 dialect: fanuc free-rotation: c-zero)
G90 G54 G0 X0. Y0. Z50. A0. B0. C0.
G43.5 H0 I0. J0. K1.
M30
