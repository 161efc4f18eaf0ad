"""A model is made of a control's files, and its workspace mapped: joints, lengths and stiffness computed here again."""

import csv
import math
import os
import pathlib
import re
import subprocess
import tempfile
import tomllib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "07_a_model_of_your_machine"
HOME = (0.0, 0.0, -820.0)


def joints():
    """(base, platform) as the HAL file sets them, mm."""
    rings = {"base": [[0.0] * 3 for _ in range(6)], "platform": [[0.0] * 3 for _ in range(6)]}
    for ring, strut, axis, value in re.findall(r"^setp genhexkins\.(\w+)\.(\d)\.([xyz]) (\S+)$",
                                               (EXAMPLE / "joints.hal").read_text(), re.MULTILINE):
        rings[ring][int(strut)]["xyz".index(axis)] = float(value)
    return rings["base"], rings["platform"]


def solved(matrix, right):
    """x with matrix x = right, by elimination with pivots."""
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    size = len(rows)
    for i in range(size):
        pivot = max(range(i, size), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(size):
            if k != i:
                factor = rows[k][i] / rows[i][i]
                rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i])]
    return [rows[i][size] / rows[i][i] for i in range(size)]


def stiffness_n_um(tip_mm, k1, k2):
    """Of the tip in its softest direction, the platform not turned; K1 in um/N per m of strut, K2 in um/N."""
    jacobian, each = [], []
    for q, p in zip(*joints()):
        d = [t + b - a for t, b, a in zip(tip_mm, p, q)]
        length = math.hypot(*d)
        u = [x / length for x in d]
        moment = [p[1] * u[2] - p[2] * u[1], p[2] * u[0] - p[0] * u[2], p[0] * u[1] - p[1] * u[0]]
        jacobian.append(u + moment)
        each.append(k1 * length / 1000 + k2)
    transposed = [list(column) for column in zip(*jacobian)]
    compliance = []
    for axis in range(3):
        tension = solved(transposed, [1.0 if i == axis else 0.0 for i in range(6)])
        compliance.append(solved(jacobian, [c * t for c, t in zip(each, tension)])[:3])
    direction = [1.0, 0.7, 0.4]
    for _ in range(500):  # the largest eigenvalue, by iteration
        moved = [sum(row[i] * direction[i] for i in range(3)) for row in compliance]
        largest = math.hypot(*moved)
        direction = [x / largest for x in moved]
    return 1 / largest


class Input(unittest.TestCase):
    def test_the_struts_are_as_long_at_home_as_the_control_says(self):
        stated = [float(x) for x in re.findall(r"^HOME = (\d\S*)$", (EXAMPLE / "bench.ini").read_text(), re.MULTILINE)]
        stated = stated[-6:]
        for (q, p), home in zip(zip(*joints()), stated):
            self.assertAlmostEqual(math.dist([h + b for h, b in zip(HOME, p)], q), home, places=3)


class WithProgram(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            cls.run_ = subprocess.run([EXAMPLE / "run", os.environ["PLUMBLINE_PROGRAM"], folder], capture_output=True, text=True)
            if cls.run_.returncode != 0:
                raise AssertionError(cls.run_.stdout + cls.run_.stderr)
            out = pathlib.Path(folder)
            cls.text = (out / "first.toml").read_text()
            cls.models = [tomllib.loads((out / name).read_text()) for name in ("first.toml", "second.toml")]
            cls.maps = [list(csv.DictReader((out / name).read_text().splitlines())) for name in ("first.csv", "second.csv")]
            cls.page = (out / "first.html").read_text()

    def test_joints_and_limits_are_the_controls(self):
        base, platform = joints()
        for model in self.models:
            self.assertEqual(model["base"]["joints_mm"], base)
            self.assertEqual(model["platform"]["joints_mm"], platform)
            self.assertEqual(model["limits"]["z_mm"], [-920, -720])
            self.assertEqual(model["strut"]["length_max_mm"], 1020)

    def test_what_is_assumed_says_so_and_what_is_stated_does_not(self):
        self.assertEqual(self.text.count("  # assumed: "), 22)
        self.assertEqual(self.models[1]["strut"]["lead_mm"], 10)
        self.assertEqual(self.models[1]["uncertainty"]["joint_position_um"], 15)
        self.assertIn("counts as no limit", self.run_.stdout)

    def test_the_stiffness_is_that_of_the_struts(self):
        for model, rows in zip(self.models, self.maps):
            k1, k2 = model["strut"]["compliance_per_length_um_N_m"], model["strut"]["compliance_um_N"]
            flat = [row for row in rows if row["in_reach"] == "1" and float(row["a_deg"]) == 0]
            for row in flat[::500]:
                tip = [float(row[key]) for key in ("x_mm", "y_mm", "z_mm")]
                self.assertAlmostEqual(float(row["stiffness_N_um"]) / stiffness_n_um(tip, k1, k2), 1, places=3)

    def test_poses_out_of_reach_are_those_with_struts_too_long_or_too_short(self):
        for row in self.maps[0]:
            if float(row["a_deg"]) != 0:
                continue
            tip = [float(row[key]) for key in ("x_mm", "y_mm", "z_mm")]
            lengths = [math.dist([t + b for t, b in zip(tip, p)], q) for q, p in zip(*joints())]
            within = all(620 <= length <= 1020 for length in lengths)
            self.assertEqual(row["in_reach"] == "1", within, row)

    def test_measured_joints_make_the_map_worth_something(self):
        largest = [max(float(row["touched_off_uncertainty_um"]) for row in rows if row["in_reach"] == "1") for rows in self.maps]
        self.assertGreater(largest[0], 1000)
        self.assertLess(largest[1], 30)
        self.assertIn("trusted within", self.page)


if __name__ == "__main__":
    unittest.main()
