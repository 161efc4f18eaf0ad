#!/usr/bin/env python3
"""Has LinuxCNC run a program as it stands and compensated, plays what its joints did on the stand-in for the machine,
and says how far the tool tip is from the programmed path, as table and plots.

usage: on_a_control.py PLUMBLINE PLAY_JOINTS FOLDER
"""

import csv
import json
import pathlib
import subprocess
import sys

import control
import deviation_plot

HERE = pathlib.Path(__file__).resolve().parent
MODEL = HERE.parents[1] / "models" / "pm600-like.toml"
OFFSET = ["--work-offset", "G54=0,0,-1008,0,0,0"]
PROGRAMS = {  # how the compensated ones are made
    "without-friction": ["--step-angle", "0.5", "--no-friction"],
    "with-friction": ["--step-angle", "0.5", "--friction-turn", "0.002"],
}
MACHINES = {  # name: what the stand-in does, which program is for it, how it is played
    "bends": ("bends", "without-friction", ["--no-friction"]),
    "rubs": ("bends, friction turns at once", "with-friction", []),
    "remembers": ("bends, friction turns over 4 um", "with-friction", ["--friction", "dahl"]),
}


def do(*command, **options):
    print("$", *command, flush=True)
    return subprocess.run([str(word) for word in command], check=True, **options)


def deviations(path):
    with open(path, newline="") as table:
        return [(float(row["time_s"]), float(row["off_um"])) for row in csv.DictReader(table)]


def play(play_joints, out, recording, machine):
    """Figures of a run, and where the tip was off."""
    table = out / f"{recording.stem}-{machine}.csv"
    result = subprocess.run([play_joints, "--machine", MODEL, "--meant", out / "wave.jsonl", "--table", table,
                             *MACHINES[machine][2], recording], check=True, stdout=subprocess.PIPE, text=True)
    return json.loads(result.stdout), deviations(table)


def table_of(summary):
    lines = [f"{'the machine':32}{'as programmed':>26}{'compensated':>26}",
             f"{'':32}{'max um':>10}{'rms um':>8}{'s':>8}{'max um':>10}{'rms um':>8}{'s':>8}"]
    for machine, (name, _, _) in MACHINES.items():
        figures = "".join(f"{run['most_um']:10.2f}{run['rms_um']:8.3f}{run['seconds']:8.2f}"
                          for run in (summary[machine]["programmed"], summary[machine]["compensated"]))
        lines.append(f"{name:32}{figures}")
    return "\n".join(lines)


def main():
    plumbline, play_joints, out = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    why_not = control.missing()
    if why_not:
        sys.exit(f"no control to run it on: {why_not}")
    out.mkdir(parents=True, exist_ok=True)
    programs = [out / "wave.ngc"]
    do(sys.executable, "-B", HERE / "make_program.py", programs[0])
    for name, options in PROGRAMS.items():
        programs.append(out / f"wave-{name}.ngc")
        do(plumbline, "compensate", programs[0], "-m", MODEL, *OFFSET, *options, "-o", programs[-1],
           stderr=subprocess.DEVNULL)
    configuration = out / "control"
    if not configuration.exists():
        do(plumbline, "control", "linuxcnc", "-m", MODEL, *OFFSET, "-o", configuration)
    with open(out / "wave.jsonl", "w") as trace:
        do(plumbline, "trace", programs[0], *OFFSET, stdout=trace)
    print("LinuxCNC runs them in their own time", flush=True)
    programmed, *recordings = control.run(configuration, programs, out)
    compensated = dict(zip(PROGRAMS, recordings))
    summary = {}
    for machine, (name, program, _) in MACHINES.items():
        before, rows_before = play(play_joints, out, programmed, machine)
        after, rows_after = play(play_joints, out, compensated[program], machine)
        summary[machine] = {"programmed": before, "compensated": after}
        title = f"A machine that {name}: the tip off the programmed path"
        curves = [("as programmed", rows_before), ("compensated", rows_after)]
        (out / f"{machine}.svg").write_text(deviation_plot.deviation_plot(title, curves))
    (out / "summary.json").write_text(json.dumps(summary, indent=1) + "\n")
    print(table_of(summary))


if __name__ == "__main__":
    try:
        main()
    except control.ControlError as problem:
        sys.exit(str(problem))
