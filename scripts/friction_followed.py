#!/usr/bin/env python3
"""What it would take to follow the friction of a strut that turns round within a block (docs/rewriting.md): how long the
turn takes where the feed is so low that pieces keep a tolerance, and how far the tip is off where shorter pieces alone
follow the turn at the full feed, the ends of each rounded up or down.

usage: friction_followed.py [--jump UM] [--v0 MM_S] [--acceleration MM_S2] [--seeds N]

One strut: L' = a t, told L' + c', off by c - k s with s = tanh((L' + c') / v0), k half of the jump. The correction without
an error is c = k s; that equation is stable backwards in time.
"""

import argparse
import math
import random

ROUNDED_UM = {"words of 0.0001 mm, 0.00001 deg": 0.12, "words of 0.000001 mm and deg": 0.0012}
TOLERANCES_UM = (0.25, 0.5, 1, 2)
PIECES_S = (0.035, 0.012, 0.004)
KEPT = 0.97  # of the tolerance
TURNED = 1.83  # v0: tanh is 0.95
FAR = 6  # v0
STEPS = 200  # of a piece


def turn_s(tolerance, rounded, jump, v0, acceleration):
    """Seconds from s = -0.95 to 0.95 where the strut turns round as slowly as the tolerance asks for."""
    left = KEPT * tolerance - rounded
    slowest = (left * v0) ** 2 / (rounded * jump**2)
    return 2 * TURNED * v0 / min(slowest, acceleration)


def before(u, t, step, k, v0, acceleration):
    """atanh(c / k) one step earlier: c - c_before = step (v0 atanh(c_before / k) - a t), by Newton's method."""
    c = k * math.tanh(u)
    for _ in range(30):
        misfit = k * math.tanh(u) + step * (v0 * u - acceleration * t) - c
        u -= misfit / (k / math.cosh(min(abs(u), 30)) ** 2 + step * v0)
        if abs(misfit) < 1e-13:
            break
    return u


def corrections(piece_s, k, v0, acceleration):
    """Time and correction at the ends of the pieces, a turn in their middle."""
    half = FAR * v0 / acceleration + 2 * k / v0
    count = int(2 * half / piece_s) + 1
    t = -half + count * piece_s
    u = acceleration * t / v0
    ends = [(t, k * math.tanh(u))]
    for _ in range(count):
        for _ in range(STEPS):
            t -= piece_s / STEPS
            u = before(u, t, piece_s / STEPS, k, v0, acceleration)
        ends.append((t, k * math.tanh(u)))
    return ends[::-1]


def most_off(piece_s, rounded, seed, k, v0, acceleration):
    draws = random.Random(seed)
    ends = [(t, c + draws.choice((-rounded, rounded))) for t, c in corrections(piece_s, k, v0, acceleration)]
    worst = 0
    for (t, c), (_, after) in zip(ends, ends[1:]):
        slope = (after - c) / piece_s
        for i in range(51):
            along = piece_s * i / 50
            if abs(t + along) <= FAR * v0 / acceleration + k / v0:
                sign = math.tanh((acceleration * (t + along) + slope) / v0)
                worst = max(worst, abs(c + slope * along - k * sign))
    return worst


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--jump", type=float, default=5, help="of the tip, um")
    parser.add_argument("--v0", type=float, default=0.02, help="mm/s")
    parser.add_argument("--acceleration", type=float, default=25**2 / 300, help="of the strut at the full feed, mm/s^2")
    parser.add_argument("--seeds", type=int, default=3)
    given = parser.parse_args()
    v0, acceleration = 1000 * given.v0, 1000 * given.acceleration
    for name, rounded in ROUNDED_UM.items():
        print(f"{name}; at the full feed a turn takes {2 * TURNED * v0 / acceleration:.3f} s")
        for tolerance in TOLERANCES_UM:
            print(f"  {tolerance} um: a turn takes {turn_s(tolerance, rounded, given.jump, v0, acceleration):.2f} s")
        for piece_s in PIECES_S:
            off = max(most_off(piece_s, rounded, seed, given.jump / 2, v0, acceleration) for seed in range(given.seeds))
            print(f"  pieces of {1000 * piece_s:.0f} ms at the full feed: off by {off:.1f} um")


if __name__ == "__main__":
    main()
