(expect: nc-tool-vector 4 16 dialect: fanuc free-rotation: c-zero)
G90 G54 G0 X0. Y0. Z50. A0. B0. C0.
G43.5 H0 Z50.
G0 X5. I.5 J0. K1
M30
