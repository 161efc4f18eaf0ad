#!/usr/bin/env python3
"""Time and memory of identify and diagnose, from short records to long ones: 26 runs of a machine that tests/truth draws, each
with a bar and six torques, that many samples a run.

usage: learning_times.py [--rounds N] [--samples N,N...] [--effect NAME,NAME...] [--plumbline PROGRAM] [--draw PROGRAM]
                         [--folder DIR]

Prints Markdown. Times are of the best round, memory is the largest of all rounds. What is found stands beside them: it must
not depend on how many samples there are.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time


def run(command):
    """Seconds, seconds of CPU, peak MB."""
    begin = time.perf_counter()
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=said)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            said.seek(0)
            sys.exit(f"{' '.join(map(str, command))}: exit {process.returncode}\n{said.read().decode(errors='replace')}")
    return time.perf_counter() - begin, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def draw(options, effect, samples, folder):
    run([options.draw, "--seed", "11", "--machine", "wide", "--effect", effect, "--snr", "60", "--samples", samples,
         "--quick", "-o", folder])
    return sum(file.stat().st_size for file in (folder / "data").iterdir()) / 1e6


def best(rounds, command):
    costs = [run(command) for _ in range(rounds)]
    return min(c[0] for c in costs), min(c[1] for c in costs), max(c[2] for c in costs)


def rows(options, folder):
    for effect in options.effect.split(","):
        for samples in options.samples.split(","):
            case = folder / f"{effect.replace(':', '-')}-{samples}"
            size = draw(options, effect, samples, case)
            given = ["-m", case / "base.toml", "-d", case / "data" / "dataset.toml"]
            # identify does not know the effect: --force, as the model is refused after the same work
            for way, out in (("identify --force", case / "learnt.toml"), ("diagnose", case / "out")):
                seconds, cpu, peak = best(options.rounds, [options.plumbline, *way.split(), *given, "-o", out])
                found = json.loads((out / "diagnosis.json").read_text())["headline"] if way == "diagnose" else ""
                yield [effect, f"{int(samples):,}", f"{size:.1f}", way, f"{seconds:.2f}", f"{cpu:.2f}", f"{peak:.0f}",
                       found.split(":")[0] if found.startswith("unknown") else found.split(",")[0]]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--samples", default="120,3600,50000")
    parser.add_argument("--effect", default="backlash,outside:cogging", help="as plumbline_draw_case names it")
    parser.add_argument("--plumbline", default="build/release/plumbline")
    parser.add_argument("--draw", default="build/release/plumbline_draw_case")
    parser.add_argument("--folder", help="for the datasets, some 70 MB each of 50000 samples (default: a temporary one)")
    options = parser.parse_args()
    head = ["machine hides", "samples a run", "MB", "command", "s", "s of CPU", "peak MB", "found"]
    with tempfile.TemporaryDirectory(dir=options.folder) as folder:
        for row in [head, ["---"] * len(head), *rows(options, pathlib.Path(folder))]:
            print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main()
