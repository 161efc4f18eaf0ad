#!/usr/bin/env python3
"""Writes the NC program of this example: a freeform crown, milled on a hexapod with a tilted ball end mill.

Stands for a CAM system: it gives RS274/NGC as one would post it, the tool tip programmed, X Y Z A B C in every cutting
block. Needs Python 3 alone and writes the same bytes at every run.

usage: make_program.py [--stepover MM] [OUTPUT]        (default: 2 mm, standard output)

Lengths are mm, angles deg; work zero is the middle of the crown, W = work + (0, 0, -1008) on models/pm600-like.toml.
"""

import argparse
import math
import sys

BALL_RADIUS = 8.0
EDGE = 100.0  # rows run from -EDGE to EDGE in X; the part ends at 95, so that the tool turns beside it
ROWS_Y = 95.0
SWAY = 3.0  # the rows are not straight: they sway by this much in Y
STOCK = 0.3  # what the rows leave for the spiral
LEAN = 3.0  # the tool leans from the surface normal, so that it does not cut at its tip
CHORD = 0.004  # largest distance of a straight piece from the surface
CLEARANCE = 40.0
SAFE = 80.0
TILT_MOST = 15.0  # between tool and Z; the program promises to keep to it
FEED = 1500.0
PLUNGE = 400.0


# The surface, and the pose of the tool that touches it -------------------------------------------------------------


def height(x, y):
    """Level along X at x = -EDGE and x = EDGE, so that rows may be joined there on the level."""
    return 4.0 * math.cos(math.pi * x / EDGE) * (1 + 0.25 * math.sin(math.pi * y / 80)) + 3.5 * math.sin(math.pi * y / 90)


def slopes(x, y):
    along_x = -4.0 * math.pi / EDGE * math.sin(math.pi * x / EDGE) * (1 + 0.25 * math.sin(math.pi * y / 80))
    along_y = math.pi / 80 * math.cos(math.pi * x / EDGE) * math.cos(math.pi * y / 80)
    return along_x, along_y + 3.5 * math.pi / 90 * math.cos(math.pi * y / 90)


def bend(x, y):
    """Second derivative along X."""
    return -4.0 * (math.pi / EDGE) ** 2 * math.cos(math.pi * x / EDGE) * (1 + 0.25 * math.sin(math.pi * y / 80))


def unit(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v)


def normal(x, y):
    along_x, along_y = slopes(x, y)
    return unit((-along_x, -along_y, 1.0))


def leaned(axis, towards, angle):
    """The tool axis, turned by `angle` towards a horizontal direction."""
    push = math.tan(math.radians(angle))
    return unit((axis[0] + push * towards[0], axis[1] + push * towards[1], axis[2]))


def angles(axis, c):
    """A and B that put the spindle along `axis` at this C: R = Rz(C) Ry(B) Rx(A), R ez = axis."""
    cos_c, sin_c = math.cos(math.radians(c)), math.sin(math.radians(c))
    x, y = cos_c * axis[0] + sin_c * axis[1], -sin_c * axis[0] + cos_c * axis[1]
    return math.degrees(math.asin(-y)), math.degrees(math.atan2(x, axis[2]))


def turn(x, y):
    """C is free (the tool is round); CAM uses it to keep the struts apart. It varies slowly over the part."""
    return 6.0 * math.sin(math.pi * x / 200) + y / 25


def pose(x, y, towards, stock=0.0, lift=0.0):
    """X Y Z A B C of the tip of the ball that touches the surface over (x, y)."""
    n = normal(x, y)
    axis = leaned(n, towards, LEAN)
    c = turn(x, y)
    contact = (x, y, height(x, y))
    tip = (p + (BALL_RADIUS + stock) * n_i - (BALL_RADIUS - lift) * a_i for p, n_i, a_i in zip(contact, n, axis))
    return (*tip, *angles(axis, c), c)


def raised(at, z):
    return (*at[:2], z, *at[3:])


# The program -------------------------------------------------------------------------------------------------------


class Post:
    """Writes blocks, as the post-processor of a CAM system does: N numbers, modal G and F words."""

    def __init__(self):
        self.lines = []
        self.number = 0
        self.motion = None
        self.feed = None
        self.at = None

    def text(self, line):
        self.lines.append(line)

    def block(self, *words):
        self.number += 5
        self.lines.append(" ".join((f"N{self.number}", *words)))

    def mode(self, *words):
        """A block without motion; after it motion and feed are stated again."""
        self.block(*words)
        self.motion = self.feed = None

    def move(self, code, to, extra="", feed=None):
        tilt = math.degrees(math.acos(math.cos(math.radians(to[3])) * math.cos(math.radians(to[4]))))
        assert tilt <= TILT_MOST and abs(to[0]) <= 110 and abs(to[1]) <= 110, to
        to = tuple(round(value, 4) + 0.0 for value in to)
        words = [] if code == self.motion else [code]
        words += [f"{axis}{value:.4f}" for axis, value in zip("XYZABC", to)]
        if extra:
            words.append(extra)
        if feed is not None and feed != self.feed:
            words.append(f"F{feed:.6g}")
            self.feed = feed
        self.block(*words)
        self.motion, self.at = code, to

    def rapid(self, to):
        self.move("G0", to)

    def line(self, to, feed=FEED):
        self.move("G1", to, feed=feed)

    def arc(self, code, to, centre, feed=FEED):
        """`centre` in X and Y; G17 is in force."""
        i, j = centre[0] - self.at[0], centre[1] - self.at[1]
        self.move(code, to, extra=f"I{i:.4f} J{j:.4f}", feed=feed)

    def line_in_time(self, to, speed):
        """Under G93: F is one over the minutes that the block takes, and stands in every block."""
        self.feed = None
        self.line(to, feed=float(f"{speed / math.dist(self.at[:3], to[:3]):.6g}"))


def begin(post, stepover):
    post.text("%")
    post.text("(PROGRAM    CROWN, 190 X 190, FREEFORM)")
    post.text("(MACHINE    HEXAPOD, SIX AXES, TOOL TIP PROGRAMMED, R = RZ[C] RY[B] RX[A])")
    post.text("(ZERO       G54, MIDDLE OF THE CROWN)")
    post.text("(TOOL 1     BALL END MILL D16, LENGTH 85)")
    post.text(f"(ROWS       STEP-OVER {stepover:g}, CHORD {CHORD:g}, LEAN {LEAN:g} DEG)")
    post.mode("G21 G17 G90 G94")
    post.mode("G54")
    post.mode("G49")
    post.mode("G64 P0.005")


def tool_change(post, start):
    post.text("(TOOL 1)")
    post.mode("T1 M6")
    post.mode("G43 H1")
    post.rapid(raised(start, SAFE))  # the tool change left the axes anywhere: all six are stated
    post.mode("S9000 M3")
    post.mode("M8")


def row_stations(y):
    """X along a row, so dense that straight pieces stay within CHORD of the surface."""
    x, stations = -EDGE, []
    while x < EDGE:
        stations.append(x)
        x += min(2.5, max(1.0, math.sqrt(8 * CHORD / max(abs(bend(x, y)), 1e-6))))
    if EDGE - stations[-1] < 0.5:
        stations.pop()
    return stations + [EDGE]


def on_row(x, y, lift=0.0):
    """Pose on the row that crosses the middle at y; level along X at both ends, as the surface is."""
    return pose(x, y + SWAY * math.sin(math.pi * x / (2 * EDGE)), (1.0, 0.0), STOCK, lift)


def rows(post, stepover):
    """Zig-zag: rows along X, joined beside the part by straight steps; every eighth time by a lift, or a half circle."""
    post.text(f"(OPERATION 1  ROWS, {STOCK:g} LEFT)")
    count = int(2 * ROWS_Y / stepover) + 1
    for row in range(count):
        y = -ROWS_Y + row * stepover
        stations = row_stations(y)
        forward = row % 2 == 0
        poses = [on_row(x, y) for x in (stations if forward else reversed(stations))]
        if row % 8 == 0:
            if row > 0:
                post.rapid(on_row(-EDGE, y - stepover, lift=5.0))
                post.rapid(raised(post.at, CLEARANCE))
            post.rapid(raised(poses[0], CLEARANCE))
            post.line(poses[0], feed=PLUNGE)
        elif row % 8 != 4:
            post.line(poses[0])
        else:
            middle = [(a + b) / 2 for a, b in zip(post.at[:2], poses[0][:2])]
            post.arc("G2" if forward else "G3", poses[0], middle)
        for at in poses[1:]:
            post.line(at)
    post.rapid(raised(post.at, CLEARANCE))


def spiral(post, stepover):
    """The crown itself, from the middle outwards, in inverse time: the tip keeps its speed whatever the axes do."""
    post.text("(OPERATION 2  SPIRAL TO SIZE, INVERSE TIME)")
    speed, first, last = 1200.0, 6.0, 60.0

    def at(theta):
        radius = first + stepover / 2 * theta / (2 * math.pi)
        outwards = (math.cos(theta), math.sin(theta))
        return radius, pose(radius * outwards[0], radius * outwards[1], outwards)

    post.rapid(raised(at(0)[1], CLEARANCE))
    post.rapid(raised(at(0)[1], at(0)[1][2] + 2.0))
    post.mode("G93")
    post.line_in_time(at(0)[1], PLUNGE)
    radius, theta = first, 0.0
    while radius < last:
        theta += min(math.radians(12), 2.5 / radius)
        radius, to = at(theta)
        post.line_in_time(to, speed)
    post.mode("G94")
    post.rapid(raised(post.at, CLEARANCE))


def groove(post):
    """A ring around the crown, by arcs in which the tool keeps leaning to the middle."""
    post.text("(OPERATION 3  RING, ARCS WITH A B C)")
    ring, lean, pieces = 84.0, 8.0, 16

    def at(theta, depth):
        outwards = (math.cos(theta), math.sin(theta))
        x, y = ring * outwards[0], ring * outwards[1]
        axis = leaned((0.0, 0.0, 1.0), (-outwards[0], -outwards[1]), lean)
        c = 5 * math.sin(theta)
        return (x, y, height(x, y) - depth, *angles(axis, c), c)

    post.rapid(raised(at(0, 0), CLEARANCE))
    post.line(at(0, 0), feed=PLUNGE)
    for turn_number, code in ((1, "G3"), (2, "G2")):
        post.line(at(0, 0.25 * turn_number), feed=PLUNGE)
        for piece in range(1, pieces + 1):
            theta = 2 * math.pi * piece / pieces * (1 if code == "G3" else -1)
            post.arc(code, at(theta, 0.25 * turn_number), (0.0, 0.0), feed=800.0)


def end(post):
    post.text("(END)")
    post.rapid(raised(post.at, SAFE))
    post.mode("M9")
    post.mode("M5")
    post.rapid((0.0, 0.0, SAFE, 0.0, 0.0, 0.0))
    post.mode("M30")
    post.text("%")


def program(stepover):
    post = Post()
    begin(post, stepover)
    tool_change(post, on_row(-EDGE, -ROWS_Y))
    rows(post, stepover)
    spiral(post, stepover)
    groove(post)
    end(post)
    return "\n".join(post.lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--stepover", type=float, default=2.0, metavar="MM", help="distance of the rows (default 2)")
    parser.add_argument("output", nargs="?", help="default: standard output")
    arguments = parser.parse_args()
    text = program(arguments.stepover)
    if arguments.output is None:
        sys.stdout.write(text)
    else:
        with open(arguments.output, "w", encoding="ascii", newline="\n") as file:
            file.write(text)


if __name__ == "__main__":
    main()
