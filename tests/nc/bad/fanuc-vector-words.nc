(expect: nc-tool-vector 4 5 dialect: fanuc free-rotation: c-zero)
G90 G54 G0 X0. Y0. Z50. A0. B0. C0.
G43.5 H0
X5. A10.
M30
