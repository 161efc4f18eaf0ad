"""The pages that the program writes, each from a small case."""
import math
import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MODEL = ROOT / "models/pm600-like.toml"
OFFSET = ["--work-offset", "G54=0,0,-1008,0,0,0"]

PROGRAM = """\
%
(A FACE AND A CIRCLE)
N10 G21 G17 G90 G94
N20 G54 G0 X-40 Y-40 Z30 A0 B0 C0
N30 Z5
N40 G1 Z0 F600
N50 X40 F1500 A6
N60 Y-20 B-4
N70 X-40 A0
N80 Y0 B0
N90 G2 X0 Y40 I40 J0 C3
N100 G3 X40 Y0 Z-2 I0 J-40 A-5
N110 G1 X0.02 F900
N120 X0 Y0.01
N130 G0 Z60
N140 M2
%
"""


def run(folder, *arguments, code=0):
    done = subprocess.run([os.environ["PLUMBLINE_PROGRAM"], *map(str, arguments)], cwd=folder, text=True,
                          capture_output=True, check=False)
    if done.returncode != code:
        raise AssertionError(f"{arguments}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done


def compensate(folder):
    (folder / "part.ngc").write_text(PROGRAM)
    run(folder, "compensate", "part.ngc", "-m", MODEL, *OFFSET, "-o", "part-compensated.ngc", "--report", "compensate.html")
    return folder / "compensate.html"


def simulate(folder):
    (folder / "part.ngc").write_text(PROGRAM)
    run(folder, "simulate", "part.ngc", "-m", MODEL, *OFFSET, "-o", "table.csv", "--report", "simulate.html")
    return folder / "simulate.html"


def check(folder):
    """A program that goes beyond a limit."""
    (folder / "part.ngc").write_text(PROGRAM.replace("N50 X40 F1500 A6", "N50 X40 F1500 A36"))
    run(folder, "check", "part.ngc", "-m", MODEL, *OFFSET, "--report", "check.html", code=3)
    return folder / "check.html"


def diff(folder):
    compensate(folder)
    run(folder, "diff", "part.ngc", "part-compensated.ngc", "--report", "diff.html")
    return folder / "diff.html"


CASE = ROOT / "tests/blind/open-01"
DATA = ["-m", CASE / "base.toml", "-d", CASE / "data/dataset.toml"]


def of_data(command, *arguments):
    def make(folder):
        run(folder, command, *DATA, "--report", f"{command}.html", *arguments)
        return folder / f"{command}.html"
    return make


def circularity(folder):
    run(folder, "circularity", "-d", CASE / "data/dataset.toml", "-m", CASE / "base.toml", "--report", "circularity.html")
    return folder / "circularity.html"


def diagnose(folder):
    run(folder, "diagnose", *DATA, "-o", "found")
    return folder / "found/report.html"


def plan(folder):
    run(folder, "plan", "-m", MODEL, "-n", "3", "--candidates", "30", "--report", "plan.html")
    return folder / "plan.html"


def machine_map(folder):
    run(folder, "map", "-m", MODEL, "--step", "60", "--report", "map.html")
    return folder / "map.html"



def long_program(folder, blocks=8000):
    """Turn after turn, each a little lower: too many lines to draw all of them in a frame without a graphics card."""
    rows = [f"G1 X{40 * math.cos(i / 20):.3f} Y{40 * math.sin(i / 20):.3f} Z{20 - i / 400:.3f} A{3 * math.sin(i / 90):.3f} F1500"
            for i in range(blocks)]
    (folder / "long.ngc").write_text("\n".join(["G21 G17 G90 G94 G54", "G0 X40 Y0 Z20 A0 B0 C0", *rows, "M2", ""]))
    run(folder, "compensate", "long.ngc", "-m", MODEL, *OFFSET, "-o", "long-compensated.ngc", "--report", "long.html")
    return folder / "long.html"


# name: (what makes it in a folder, whether it has a scene, at least so many drawings)
PAGES = {
    "compensate": (compensate, True, 10),
    "simulate": (simulate, True, 9),
    "check": (check, True, 10),
    "diff": (diff, True, 6),
    "compare": (of_data("compare"), False, 3),
    "inspect": (of_data("inspect"), False, 1),
    "circularity": (circularity, False, 1),
    "identify": (of_data("identify", "--force", "-o", "model.toml"), False, 2),
    "calibrate": (of_data("calibrate", "--force", "-o", "model.toml"), False, 2),
    "diagnose": (diagnose, False, 5),
    "plan": (plan, False, 2),
    "map": (machine_map, False, 1),
}
