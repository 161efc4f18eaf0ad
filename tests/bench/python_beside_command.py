#!/usr/bin/env python3
"""How much longer Python takes than the command for the same program: plumbline.compensate of a string of 100,000 blocks
beside `plumbline compensate` of the same text in a file, in turns.

usage: PYTHONPATH=build/release/python /usr/bin/python3 tests/bench/python_beside_command.py [PROGRAM-TO-RUN] [TIMES]
"""
import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import plumbline

ROOT = Path(__file__).resolve().parents[2]
MODEL = ROOT / "models/pm600-like.toml"
BLOCKS = 100_000


def program():
    """A curve that leans: every block moves all six axes."""
    lines = ["G21 G90 G94", "G0 X0 Y0 Z0 A0 B0 C0", "F1500"]
    for i in range(BLOCKS):
        turn = 2 * math.pi * i / 5000
        lines.append(f"G1 X{90 * math.cos(turn):.4f} Y{90 * math.sin(turn):.4f} Z{-10 * math.cos(turn / 7):.4f} "
                     f"A{6 * math.sin(turn):.4f} B{6 * math.cos(turn):.4f} C{4 * math.sin(turn / 3):.4f}")
    return "\n".join([*lines, "M2", ""])


def spent(who):
    used = resource.getrusage(who)
    return used.ru_utime + used.ru_stime


def timed(work, who):
    cpu, wall = spent(who), time.perf_counter()
    work()
    return spent(who) - cpu, time.perf_counter() - wall


def main():
    command = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/plumbline"
    times = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    text = program()
    texts = {}
    with tempfile.TemporaryDirectory() as folder:
        part, output = Path(folder) / "part.ngc", Path(folder) / "out.ngc"
        part.write_text(text)

        def by_command():
            subprocess.run([command, "compensate", part, "-m", MODEL, "--work-offset", "G54=0,0,-1008,0,0,0", "-o", output,
                            "--no-settings", "-q"], check=True)

        def by_python():
            texts["python"] = plumbline.compensate(text, MODEL, work_offset={"G54": (0, 0, -1008, 0, 0, 0)}).text

        figures = {"command": [], "python": []}
        for _ in range(times):
            figures["command"].append(timed(by_command, resource.RUSAGE_CHILDREN))
            figures["python"].append(timed(by_python, resource.RUSAGE_SELF))
        assert output.read_text() == texts["python"], "the texts differ"
    print(f"{BLOCKS} blocks, {os.cpu_count()} processors, the least of {times}: seconds of CPU, seconds")
    least = {}
    for name, pairs in figures.items():
        least[name] = [min(pair[i] for pair in pairs) for i in (0, 1)]
        print(f"{name:8} {least[name][0]:8.3f} {least[name][1]:8.3f}   median {statistics.median(p[1] for p in pairs):.3f}")
    print(f"python over command {least['python'][0] / least['command'][0]:.3f} {least['python'][1] / least['command'][1]:.3f}")


if __name__ == "__main__":
    main()
