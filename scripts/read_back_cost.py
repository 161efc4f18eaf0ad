#!/usr/bin/env python3
"""What reading the output back adds to the time of compensate: both ways by turns, several kinds of programs.

usage: read_back_cost.py [--rounds N] [--program FILE]... [--lines N]
"""
import argparse
import math
import os
import resource
import subprocess
import tempfile
import time

PLUMBLINE = "build/release/plumbline"
COMMAND = [PLUMBLINE, "compensate", "-m", "models/pm600-like.toml", "--work-offset", "G54=0,0,-1008,0,0,0"]
HEAD = "G21 G90 G94 G54 G17\nG0 X0 Y0 Z20 A0 B0 C0\n"


def kinds(lines):
    """Programs by name: text, options."""
    short = "".join(f"G1 X{i % 97 * 0.4:.3f} Y{i % 89 * 0.4:.3f} Z{i % 7 * 0.05:.3f}\n" for i in range(lines))
    five = "".join(
        f"G1 X{30 * math.cos(i / 50):.4f} Y{30 * math.sin(i / 50):.4f} A{5 * math.sin(i / 90):.4f} B{4 * math.cos(i / 70):.4f}\n"
        for i in range(lines))
    arcs = "".join(f"G{2 + i % 2} X{10 * (1 - i % 2)} Y0 I{5 - 10 * (i % 2)} J0\n" for i in range(1, lines // 200))
    loop = f"o1 repeat [{lines // 4}]\nG91 G1 X1 Y0.5\nX-1 Y-0.5\nG90\no1 endrepeat\n"
    feed = HEAD + "G1 Z0 F1500\n"
    return {
        "short lines": (feed + short + "M2\n", []),
        "five axes": (feed + five + "M2\n", []),
        "arcs": (feed + "G1 X10 Y0\n" + arcs + "M2\n", []),
        "long lines, steps of 1 mm": (feed + "".join(f"G1 X{i % 2 * 90} Y{i % 50}\n" for i in range(lines // 90)) + "M2\n", []),
        "a loop, unrolled": (feed + loop + "M2\n", []),
    }


def run(program, out, options):
    """Elapsed and processor seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begin = time.perf_counter()
    subprocess.run(COMMAND + options + [program, "-o", out], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    elapsed = time.perf_counter() - begin
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return elapsed, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--lines", type=int, default=40000)
    parser.add_argument("--program", action="append", default=[], help="FILE OPTION...: a program of your own, beside the drawn ones")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        programs = []
        for name, (text, options) in kinds(arguments.lines).items():
            path = os.path.join(folder, f"{len(programs)}.ngc")
            with open(path, "w", encoding="ascii") as file:
                file.write(text)
            programs.append((name, path, options))
        for path, *options in map(str.split, arguments.program):
            programs.append((os.path.basename(path), path, options))
        print(f"{'':28} {'without':>9} {'with':>9}   elapsed   processor")
        for name, path, options in programs:
            out = os.path.join(folder, "out.ngc")
            best = {}
            for _ in range(arguments.rounds):
                for key, more in (("without", ["--no-read-back"]), ("with", [])):
                    took = run(path, out, options + more)
                    best[key] = tuple(map(min, zip(took, best.get(key, took))))
            elapsed = best["with"][0] / best["without"][0] - 1
            processor = best["with"][1] / best["without"][1] - 1
            print(f"{name:28} {best['without'][0]:8.3f}s {best['with'][0]:8.3f}s  {elapsed:+7.0%}  {processor:+9.0%}", flush=True)


if __name__ == "__main__":
    main()
