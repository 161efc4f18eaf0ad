"""Two suspects, the test that was proposed, and one that is left."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "11_until_one_is_left"
DAMPING = 23.72  # what was hidden, N m s/rad: plumbline_draw_case --seed 16 --effect joint-viscous --snr 40


def runs_of(folder):
    return tomllib.loads((EXAMPLE / folder / "dataset.toml").read_text())["run"]


class Input(unittest.TestCase):
    def test_the_first_circles_have_one_feed_and_the_next_another(self):
        self.assertEqual({run["feed_mm_min"] for run in runs_of("first")}, {1000})
        self.assertEqual([run["feed_mm_min"] for run in runs_of("next")], [6000])
        self.assertEqual(len(runs_of("first")), 6)

    def test_every_table_belongs_to_a_run(self):
        for folder in ("first", "next"):
            files = {path.name for path in (EXAMPLE / folder).glob("*.csv")}
            self.assertEqual(files, {run["file"] for run in runs_of(folder)})


class WithProgram(unittest.TestCase):
    def test_one_is_left(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([EXAMPLE / "run", os.environ["PLUMBLINE_PROGRAM"], folder], capture_output=True, text=True)
            self.assertEqual(run.returncode, 0, run.stderr)
            read = lambda name: json.loads(pathlib.Path(folder, name).read_text())
            first, both = read("first/diagnosis.json"), read("both/diagnosis.json")
            suspect, found = read("suspect.json"), read("found.json")
            self.assertTrue(pathlib.Path(folder, "first/next-test-joint-viscous.ngc").is_file())
        self.assertEqual(first["confidence_set"], ["joint-coulomb", "joint-viscous"])
        test, measured = first["next_tests"][0]["test"], runs_of("next")[0]
        for key in test:  # the circle that was measured is the one that was proposed
            self.assertEqual(test[key], measured[key], key)
        self.assertEqual(both["confidence_set"], ["joint-viscous"])
        self.assertEqual([one["runs"] for one in both["datasets"]], [6, 1])
        self.assertEqual(both["next_tests"], [])
        effect, = both["effects"]
        self.assertLess(abs(effect["parameters"]["damping_Nms_rad"] - DAMPING),
                        2 * effect["standard_errors"]["damping_Nms_rad"])
        self.assertGreater(suspect["radial_rms_um"], 2)
        self.assertLess(found["radial_rms_um"], 0.6)  # the noise is 0.5
        # the README has these lines
        for line in (EXAMPLE / "README.md").read_text().splitlines():
            if re.match(r"named: |  joint-|01-ccw ", line):
                self.assertIn(line, run.stdout)


class Drawn(unittest.TestCase):
    def test_a_machine_that_is_drawn_goes_the_same_way(self):
        program, draw = os.environ["PLUMBLINE_PROGRAM"], os.environ["PLUMBLINE_DRAW_CASE"]
        run = subprocess.run([sys.executable, "-B", EXAMPLE / "close_the_loop.py", "--plumbline", program, "--draw", draw,
                              "--seeds", "15:17"], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stdout.splitlines(), ["seed 15: joint-viscous or joint-coulomb -> joint-viscous",
                                                   "seed 16: joint-coulomb or joint-viscous -> joint-viscous",
                                                   "at the end: joint-viscous 2"])


if __name__ == "__main__":
    unittest.main()
