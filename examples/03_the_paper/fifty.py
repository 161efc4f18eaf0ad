#!/usr/bin/env python3
"""fifty.py PLUMBLINE DRAW_CASE [--seeds 1:51] [--plan paper]: the same on many machines drawn from [uncertainty].

Prints the circularity before and after for each at A = -25 deg and at (-70, -70), A = B = -17, the medians of the
reduction, and how many machines reach what the paper reached on one."""

import argparse
import concurrent.futures
import os
import statistics
import tempfile

from experiment import CORNER, FRICTION_TURN, Experiment, run_id

STEEP = run_id(-25)
PAPER_PERCENT = {STEEP: 77.9, CORNER: 69.4}


def reductions(options, seed):
    with tempfile.TemporaryDirectory() as folder:
        machine = Experiment(options.plumbline, options.draw_case, folder, seed, options.friction,
                             friction_turn=options.friction_turn)
        samples = 720 if options.plan == "paper" else 120
        model = machine.learn(machine.measure("learn", options.plan, samples=samples), command=options.learn)
        before = machine.circularities_um(machine.measure("uncompensated", "figures"))
        after = machine.circularities_um(machine.compensate_and_run(model))
    return {name: (before[name], after[name]) for name in PAPER_PERCENT}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("plumbline")
    parser.add_argument("draw_case")
    parser.add_argument("--seeds", default="1:51", help="FIRST:END, END not included")
    parser.add_argument("--plan", default="paper", help="paper: conditions A and B alone; eight-pose: 26 runs")
    parser.add_argument("--friction", default="stribeck")
    parser.add_argument("--learn", default="identify", choices=("identify", "calibrate"))
    parser.add_argument("--friction-turn", default=FRICTION_TURN, help="as of compensate: how soon corrections follow friction that turns")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    seeds = range(*(int(part) for part in options.seeds.split(":")))
    percent = {name: [] for name in PAPER_PERCENT}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for seed, found in zip(seeds, pool.map(lambda seed: reductions(options, seed), seeds)):
            for name, (before, after) in found.items():
                percent[name].append(100 * (1 - after / before))
            print(f"machine {seed:3d}  " + "   ".join(
                f"{name}: {before:6.1f} -> {after:5.1f} um" for name, (before, after) in found.items()), flush=True)
    for name, paper in PAPER_PERCENT.items():
        values = sorted(percent[name])
        reached = sum(value >= paper for value in values)
        print(f"{name}: reduction, median {statistics.median(values):.1f} % (paper {paper} %), least {values[0]:.1f} %, "
              f"most {values[-1]:.1f} %; {reached} of {len(values)} machines reach the paper's")


if __name__ == "__main__":
    main()
