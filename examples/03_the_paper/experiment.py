"""The experiments of Ibaraki et al. on a machine that stands in for theirs: measure, identify, compensate, measure again.

Only this module runs programs: plumbline, and plumbline_draw_case, the machine. Standard library only."""

import csv
import json
import math
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODEL = ROOT / "models" / "pm600-like.toml"
TILTS_DEG = (-25, -23, -20, -10, 0, 10, 20)
RADIUS_MM = 144
FEED_MM_MIN = 1000
FEED_IN_DEG = 10
FRICTION_TURN = 0.002  # of the feed: a turn of friction done within half a degree of this circle
SAMPLES = 720


def run_id(a_deg):
    return f"a{a_deg:+03d}"


CORNER = "a-17-b-17"  # Fig. 7 (b) and 9 (b)
CIRCLES = {run_id(a): ((0, 100, -1008), (a, 0, 0)) for a in TILTS_DEG}
CIRCLES[CORNER] = ((-70, -70, -1008), (-17, -17, 0))


def circle_program(centre_mm, tilt_deg):
    """One turn counter-clockwise from angle zero, fed in along the circle, as a control is told to make it."""
    x, y, z = centre_mm
    a, b, c = tilt_deg
    angle = math.radians(FEED_IN_DEG)
    into_x, into_y = round(RADIUS_MM * math.cos(angle), 4), -round(RADIUS_MM * math.sin(angle), 4)
    return (f"(circular test, radius {RADIUS_MM} mm)\nG21 G90 G94 G17 G54\n"
            f"G0 X{x + into_x:.4f} Y{y + into_y:.4f} Z{z} A{a} B{b} C{c}\n"
            f"G3 X{x + RADIUS_MM} Y{y} I{-into_x:.4f} J{-into_y:.4f} F{FEED_MM_MIN}\n"
            f"G3 X{x + RADIUS_MM} Y{y} I-{RADIUS_MM} J0\nM2\n")


class Experiment:
    """One machine, drawn from a seed, and everything that is done with it, in one folder."""

    def __init__(self, plumbline, draw, folder, seed, friction="stribeck", model=MODEL, friction_turn=FRICTION_TURN):
        self.plumbline, self.draw, self.model = pathlib.Path(plumbline), pathlib.Path(draw), model
        self.folder, self.seed, self.friction = pathlib.Path(folder), seed, friction
        self.friction_turn = friction_turn
        self.folder.mkdir(parents=True, exist_ok=True)

    def call(self, *command):
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(map(str, command))}\n{done.stderr}")
        return done.stdout

    def measure(self, name, plan, *more, samples=SAMPLES):
        """The readings of a plan; gives the dataset."""
        self.call(self.draw, "--seed", self.seed, "--machine", self.model, "--effect", "none", "--plan", plan, "--samples",
                  samples, "--friction", self.friction, "-o", self.folder / name, *more)
        return self.folder / name / "data" / "dataset.toml"

    def learn(self, dataset, *more, command="identify"):
        """The model that was learnt from a dataset, by identify or calibrate."""
        self.call(self.plumbline, command, "-m", self.model, "-d", dataset, "-o", self.folder / "identified.toml",
                  "--json", self.folder / "identify.json", *more)
        return self.folder / "identified.toml"

    def compare(self, model, dataset):
        out = self.folder / "compare.json"
        self.call(self.plumbline, "compare", "-m", model, "-d", dataset, "--json", out)
        return {run["id"]: run for run in json.loads(out.read_text())["runs"]}

    def predict(self, model, dataset):
        out = self.folder / "predicted"
        self.call(self.plumbline, "simulate", "-m", model, "-d", dataset, "-o", out)
        return out / "dataset.toml"

    def compensate_and_run(self, model):
        """Programs of the circles, compensated with the model every 0.1 deg, run on the machine; gives the dataset."""
        programs, traces = self.folder / "programs", self.folder / "traces"
        programs.mkdir(exist_ok=True)
        traces.mkdir(exist_ok=True)
        zero = ("--work-offset", "G54=0,0,0,0,0,0")
        for name, circle in CIRCLES.items():
            source, result = programs / f"{name}.ngc", programs / f"{name}-compensated.ngc"
            source.write_text(circle_program(*circle))
            self.call(self.plumbline, "compensate", source, "-m", model, "-o", result, "--step-angle", "0.1",
                      "--friction-turn", self.friction_turn, *zero)
            self.call(self.plumbline, "trace", result, "-o", traces / f"{name}.jsonl", *zero)
        return self.measure("compensated", "figures", "--programs", traces)

    def circularities_um(self, dataset):
        out = self.folder / "circularity.json"
        self.call(self.plumbline, "circularity", "-d", dataset, "--json", out)
        return {run["id"]: run["circularity_um"] for run in json.loads(out.read_text())["runs"]}


def profile(dataset, name):
    """Angles in deg and bar readings in um of a run."""
    with open(pathlib.Path(dataset).parent / f"{name}.csv", newline="") as table:
        rows = list(csv.DictReader(table))
    return [float(row["angle_deg"]) for row in rows], [float(row["radial_um"]) for row in rows]
