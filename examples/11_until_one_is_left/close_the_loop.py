#!/usr/bin/env python3
"""The way of this example on machines that are drawn: six circles, the test that the diagnosis proposes, measured on the
same machine, and both together, until one name is left or no test is proposed.

  close_the_loop.py --plumbline PLUMBLINE --draw PLUMBLINE_DRAW_CASE --effect joint-viscous --snr 40 --seeds 14:31

PLUMBLINE_DRAW_CASE is built with the tests: a simulator that shares no code with plumbline. Standard library only."""

import argparse
import collections
import json
import pathlib
import re
import subprocess
import tempfile

MOST_TESTS = 3


def draw(options, seed, circles, folder):
    """The case of a seed, the circles that were proposed measured in the folder more."""
    command = [options.draw, "--quick", "--seed", str(seed), "--machine", options.machine, "--effect", options.effect,
               "--snr", options.snr, "-o", folder, *(f"--circle={circle}" for circle in circles)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    path = folder / "data" / "dataset.toml"
    head, *runs = path.read_text().split("\n[[run]]\n")
    few = [run for run in runs if re.match(r'id = "0[1-6]-', run)]
    path.write_text("\n[[run]]\n".join([head, *few]))


def diagnosis(options, folder, with_more):
    more = ["--with", folder / "more" / "dataset.toml"] if with_more else []
    command = [options.plumbline, "diagnose", "-m", folder / "base.toml", "-d", folder / "data" / "dataset.toml", *more,
               "-o", folder / "found"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return json.loads((folder / "found" / "diagnosis.json").read_text())


def circle_of(found):
    """The first test that was proposed, as plumbline_draw_case takes it; None: there is none."""
    for proposed in found["next_tests"]:
        test = proposed["test"]
        if test:
            numbers = [*test["centre_mm"], *test["tilt_deg"], test["direction"], test["feed_mm_min"], test["payload_kg"]]
            return ",".join(map(str, numbers))
    return None


def names_of(found):
    return " or ".join(found["confidence_set"]) if found["verdict"] == "named" else found["verdict"]


def close(options, seed, scratch):
    """What was said after the six circles, and after each test."""
    said, circles = [], []
    while True:
        folder = scratch / f"{seed}-{len(circles)}"
        draw(options, seed, circles, folder)
        found = diagnosis(options, folder, bool(circles))
        said.append(names_of(found))
        circle = circle_of(found)
        if circle is None or circle in circles or len(circles) == MOST_TESTS:
            return said
        circles.append(circle)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plumbline", required=True)
    parser.add_argument("--draw", required=True)
    parser.add_argument("--machine", default="pm")
    parser.add_argument("--effect", default="joint-viscous")
    parser.add_argument("--snr", default="40")
    parser.add_argument("--seeds", default="14:31")
    options = parser.parse_args()
    ends = collections.Counter()
    with tempfile.TemporaryDirectory() as scratch:
        for seed in range(*map(int, options.seeds.split(":"))):
            said = close(options, seed, pathlib.Path(scratch))
            ends[said[-1]] += 1
            print(f"seed {seed}: {' -> '.join(said)}", flush=True)
    print("at the end: " + ", ".join(f"{name} {count}" for name, count in ends.most_common()))


if __name__ == "__main__":
    main()
