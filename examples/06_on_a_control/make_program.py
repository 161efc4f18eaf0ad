#!/usr/bin/env python3
"""Writes the NC program of this example: a closed wave around a dome, the tool leaning outwards, then an arc and back.

Stands for a CAM system: RS274/NGC with X Y Z A B C of the tool tip in every block, mm and deg. Needs Python 3 alone and
writes the same bytes at every run.

usage: make_program.py OUTPUT
"""

import math
import sys

BLOCKS = 160  # around the wave
HEAD = """(PROGRAM    WAVE AROUND A DOME, SIX AXES, TOOL TIP PROGRAMMED)
G21 G17 G90 G94
G54
G49
G64 P0.001
G0 X{0[0]:.4f} Y{0[1]:.4f} Z20 A{0[3]:.4f} B{0[4]:.4f} C{0[5]:.4f}
G1 Z{0[2]:.4f} F900
F1500
"""


def pose(turn):
    """X Y Z (mm) and A B C (deg) at an angle around the dome."""
    reach = 52 + 7 * math.cos(3 * turn)
    lean = 15 + 4 * math.cos(2 * turn)
    return (reach * math.cos(turn), reach * math.sin(turn), 5 * math.sin(2 * turn),
            lean * math.sin(turn), -lean * math.cos(turn), 4 * math.sin(turn))


def program():
    lines = [HEAD.format(pose(0))]
    for i in range(1, BLOCKS + 1):
        words = pose(2 * math.pi * i / BLOCKS)
        lines.append(" ".join(f"{axis}{value:.4f}" for axis, value in zip("XYZABC", words)) + "\n")
    lines.append("G3 X39 Y20 I-20 J0 A6 B-15 F900\nG1 X0 Y0 Z0 A0 B0 C0 F1500\nG0 Z20\nM2\n")
    return "".join(lines)


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="ascii", newline="\n") as file:
        file.write(program())
