#!/usr/bin/env python3
"""How the time and memory of compensate grow with the length of a program, beside rs274 (LinuxCNC's interpreter, where it
is installed) reading the same file and cat copying it: all of them by turns in one run.

usage: growth.py [--rounds N] [--blocks N,N...] [--plumbline PROGRAM] [--folder DIR]

Prints Markdown: ratios first, then seconds and memory. A block is `N.. G1 X Y Z A B C` of at most 1 mm and 0.1 deg, so that
each becomes one block. Times are of the best round, memory is the largest of all rounds, read while a command runs (VmHWM).
"""

import argparse
import dataclasses
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

HEAD = "G21 G17 G90 G94 G54\nG0 X60 Y0 Z0 A0 B-5 C0\nF1500\n"
MODEL = ["-m", "models/pm600-like.toml", "--work-offset", "G54=0,0,-1008,0,0,0"]
COMPENSATE, ALONE, COPY = "compensate", "compensate --no-read-back", "cat"
READER, PRINTER = "rs274 reads", "rs274 reads and prints"


@dataclasses.dataclass
class Cost:
    seconds: float = math.inf
    cpu: float = math.inf
    megabytes: float = 0.0

    def or_better(self, other):
        return Cost(min(self.seconds, other.seconds), min(self.cpu, other.cpu), max(self.megabytes, other.megabytes))


def write_program(path, blocks):
    """Turn after turn around a dome, each turn a little wider or narrower."""
    a_turn = 720
    with open(path, "w", encoding="ascii") as file:
        file.write(HEAD)
        for i in range(1, blocks + 1):
            turn = 2 * math.pi * i / a_turn
            wide = 60 + 10 * math.sin(turn / 37)
            file.write(f"N{i % 99999} G1 X{wide * math.cos(turn):.4f} Y{wide * math.sin(turn):.4f} "
                       f"Z{3 * math.sin(turn / 11):.4f} A{5 * math.sin(turn):.4f} B{-5 * math.cos(turn):.4f} "
                       f"C{2 * math.sin(turn / 7):.4f}\n")
        file.write("M2\n")


def high_water(pid):
    """Peak resident memory in MB of a process that still runs; else nothing."""
    try:
        with open(f"/proc/{pid}/status", encoding="ascii") as status:
            line = next((line for line in status if line.startswith("VmHWM:")), "VmHWM: 0")
    except (FileNotFoundError, ProcessLookupError):
        return 0.0
    return int(line.split()[1]) / 1024


def run(command, output, folder):
    with open(output, "wb") as out, tempfile.TemporaryFile() as said:
        begin = time.perf_counter()
        process = subprocess.Popen(command, stdout=out, stderr=said, cwd=folder)
        megabytes = 0.0
        while True:
            megabytes = max(megabytes, high_water(process.pid))
            ended, status, usage = os.wait4(process.pid, os.WNOHANG)
            if ended:
                break
            time.sleep(0.002)
        seconds = time.perf_counter() - begin
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            said.seek(0)
            sys.exit(f"{' '.join(command)}: exit code {process.returncode}\n{said.read().decode(errors='replace')}")
    return Cost(seconds, usage.ru_utime + usage.ru_stime, megabytes)


def commands(plumbline, program, folder):
    """Name: command, where its standard output goes, in which folder."""
    compensated = [plumbline, "compensate", str(program), *MODEL, "-o", str(folder / "out.ngc")]
    every = {COMPENSATE: (compensated, os.devnull, None), ALONE: (compensated + ["--no-read-back"], os.devnull, None),
             COPY: (["cat", str(program)], folder / "copy.ngc", None)}
    if shutil.which("rs274"):  # /dev/null takes all it prints: in large parts as its file, line by line as its output
        every[READER] = (["rs274", "-g", str(program), os.devnull], os.devnull, folder)
        every[PRINTER] = (["rs274", "-g", str(program)], os.devnull, folder)
    return every


def measure(plumbline, folder, blocks, rounds):
    program = folder / "growth.ngc"
    write_program(program, blocks)
    best = {}
    for _ in range(rounds):
        for name, (command, output, where) in commands(plumbline, program, folder).items():
            best[name] = best.get(name, Cost()).or_better(run(command, output, where))
    with open(folder / "out.ngc", "rb") as out:
        written = sum(1 for _ in out)
    return best, program.stat().st_size / 1e6, written


def ratio(above, below):
    return f"{above / below:.2f}" if above > 0 and below > 0 else "-"


def table(head, rows):
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, ["---"] * len(head), *rows])


def report(results):
    ratios, costs = [], []
    for blocks, (best, size, written) in results.items():
        for name in (COMPENSATE, ALONE):
            reader, printer = best.get(READER, Cost(0, 0)), best.get(PRINTER, Cost(0, 0))
            ratios.append([f"{blocks:,}", name, ratio(reader.seconds, best[name].seconds),
                           ratio(printer.seconds, best[name].seconds), ratio(reader.cpu, best[name].cpu),
                           ratio(best[name].cpu, best[COPY].cpu), f"{written / blocks:.2f}"])
        for name, cost in best.items():
            costs.append([f"{blocks:,}", f"{size:.1f}", name, f"{cost.seconds:.3f}", f"{cost.cpu:.3f}",
                          f"{blocks / cost.seconds:,.0f}", f"{cost.megabytes:.1f}"])
    yield table(["blocks", "command", "rs274's time over its own", "printing line by line",
                 "rs274's CPU over its own", "its CPU over cat's", "blocks out a block"], ratios)
    yield table(["blocks", "MB", "command", "s", "s of CPU", "blocks/s", "peak MB"], costs)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--blocks", default="10000,100000,1000000,3000000")
    parser.add_argument("--plumbline", default="build/release/plumbline")
    parser.add_argument("--folder", help="for the programs, some 1.3 GB (default: a temporary one)")
    arguments = parser.parse_args()
    results = {}
    with tempfile.TemporaryDirectory(dir=arguments.folder) as folder:
        for blocks in map(int, arguments.blocks.split(",")):
            results[blocks] = measure(arguments.plumbline, pathlib.Path(folder).resolve(), blocks, arguments.rounds)
    print("\n\n".join(report(results)))


if __name__ == "__main__":
    main()
