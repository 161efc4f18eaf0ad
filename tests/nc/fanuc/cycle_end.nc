O0031 (G80 ends the cycle alone, and the G0 from before it goes on)
G17 G21 G40 G49 G80 G90
G0 X0 Y0 Z20.
G98 G81 X10. Z-5. R2. F100
X20.
G80
Z30.
X5. Y5.
G1 Z25. F200
G0 Z21.
G99 G85 X6. Y6. Z-3. R2. F80
G80 (the last move of G85 is a feed)
Z22.
B10.
G80
X1.
G73 X2. Z-2. R1. Q5. F50
G83 X3. Z-2. R1. Q5.
G80
G73 X4. Z-2. R1. Q5.
G80 Z41. (beside it)
Y9. Z40.
M30
