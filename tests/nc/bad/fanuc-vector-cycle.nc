(expect: nc-tool-vector 4 1 dialect: fanuc free-rotation: c-zero)
G90 G54 G0 X0. Y0. Z50. A0. B0. C0.
G43.5 H0 Z50.
G81 X5. Z-5. R2. F100.
M30
