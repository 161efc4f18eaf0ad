#!/usr/bin/env python3
"""the_paper.py PLUMBLINE DRAW_CASE FOLDER [--seed N]: the experiments of the paper on a stand-in for its machine.

Prints the paper's figures beside those of the stand-in, and writes polar plots as SVG into FOLDER."""

import argparse
import json
import pathlib

from experiment import CORNER, TILTS_DEG, Experiment, profile, run_id
from polar_plot import centred, polar_plot

# What Ibaraki et al. print.
PAPER_TORQUE_NM = {"a": 0.11, "b": 0.25}
PAPER_UM = {run_id(-25): (200.6, 44.5, 77.9), CORNER: (116.2, 35.6, 69.4)}  # before, after, reduction in %
PAPER_SMALL = [run_id(a) for a in (-10, 0, 10, 20)]  # "less than 15 um"


def place_text(name):
    return "(-70, -70), A = B = -17" if name == CORNER else f"(0, 100), A = {int(name[1:])}"


def reduction(before, after):
    return 100 * (1 - after / before)


def paper_text(name):
    if name in PAPER_UM:
        return "{:8.1f}{:8.1f}{:8.1f} %".format(*PAPER_UM[name])
    return f"{'< 15':>8}{'less':>8}{'':10}" if name in PAPER_SMALL else f"{'(a bar only)':>16}{'':10}"


def print_torques(compared):
    print("\nTorque profiles, mean error (N m)          paper   here")
    means = {}
    for name, condition in (("a", "A: A = 0"), ("b", "B: A = -23 deg")):
        errors = compared[name]["torque_mean_abs_Nm"]
        means[name] = sum(errors) / len(errors)
        print(f"  condition {condition:30}{PAPER_TORQUE_NM[name]:6.2f}{means[name]:8.3f}")
    return means


def print_profiles(compared):
    print("\nFig. 7: profile of the bar, predicted against measured (um rms)")
    for name, place in ((run_id(-23), "(a) (0, 100, -1008), A = -23: as identified from"),
                        (CORNER, "(b) (-70, -70, -1008), A = B = -17: not seen before")):
        print(f"  {place:56}{compared[name]['radial_rms_um']:6.2f}")


def print_circularities(before, after):
    print("\nFig. 8 and 9: circularity (um), without and with compensation")
    print(f"  {'':28}{'paper':>12}{'':14}{'here':>12}")
    for name in [run_id(a) for a in TILTS_DEG] + [CORNER]:
        ours = f"{before[name]:8.1f}{after[name]:8.1f}{reduction(before[name], after[name]):8.1f} %"
        print(f"  {place_text(name):26}{paper_text(name)}{ours}")


def write_plots(folder, measured, predicted, compensated):
    def shown(dataset, name, label):
        angles, radial = profile(dataset, name)
        return label, angles, centred(angles, radial)

    for figure, name in (("fig7a", run_id(-23)), ("fig7b", CORNER)):
        curves = [shown(predicted, name, "simulated"), shown(measured, name, "measured")]
        (folder / f"{figure}.svg").write_text(polar_plot(f"Fig. 7: {place_text(name)} deg", curves))
    for figure, name in (("fig9a", run_id(-25)), ("fig9b", CORNER)):
        curves = [shown(compensated, name, "with compensation"), shown(measured, name, "without")]
        (folder / f"{figure}.svg").write_text(polar_plot(f"Fig. 9: {place_text(name)} deg", curves))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("plumbline")
    parser.add_argument("draw_case")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=4)
    options = parser.parse_args()
    machine = Experiment(options.plumbline, options.draw_case, options.folder, options.seed)

    table_2 = machine.measure("table2", "paper")
    model = machine.learn(table_2)
    torques = print_torques(machine.compare(model, table_2))
    measured = machine.measure("uncompensated", "figures")
    profiles = machine.compare(model, measured)
    print_profiles(profiles)
    compensated = machine.compensate_and_run(model)
    before, after = machine.circularities_um(measured), machine.circularities_um(compensated)
    print_circularities(before, after)
    write_plots(options.folder, measured, machine.predict(model, measured), compensated)
    summary = {"torque_mean_abs_Nm": torques, "before_um": before, "after_um": after,
               "profile_rms_um": {name: profiles[name]["radial_rms_um"] for name in (run_id(-23), CORNER)}}
    (options.folder / "summary.json").write_text(json.dumps(summary, indent=1))
    print(f"\nplots: {options.folder}/fig7a.svg, fig7b.svg, fig9a.svg, fig9b.svg")


if __name__ == "__main__":
    main()
