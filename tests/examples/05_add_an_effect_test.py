"""The example that adds an effect: the list has grown by two lines, and the effect does what its formula says."""

import csv
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "05_add_an_effect"
PROGRAM = os.environ["EXAMPLE_PROGRAM"]
LIST = pathlib.Path(os.environ["EXAMPLE_LIST"])
MIDDLE_MM = 1300
STIFFNESS_N_M = 500


def rows(path):
    with open(path, newline="") as table:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(table)]


class AddAnEffect(unittest.TestCase):
    def test_two_lines_are_all(self):
        before = (ROOT / "src" / "physics" / "effects" / "list.hpp").read_text()
        after = LIST.read_text()
        self.assertEqual(after.replace('#include "bellows.hpp"\n', "").replace("Bellows,\n", ""), before)
        self.assertEqual(len(after.splitlines()), len(before.splitlines()) + 2)

    def test_acts_on_its_strut_by_its_formula(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([EXAMPLE / "run", PROGRAM, folder], check=True, stdout=subprocess.DEVNULL)
            without, with_it = rows(f"{folder}/without.csv"), rows(f"{folder}/with.csv")
        self.assertEqual(len(with_it), 3)
        for one, other in zip(without, with_it):
            added = -STIFFNESS_N_M * (one["length1_mm"] - MIDDLE_MM) / 1000
            self.assertAlmostEqual(other["drive1_N"] - one["drive1_N"], added, places=4)
            self.assertNotAlmostEqual(added, 0, places=1)
            self.assertEqual(other["drive2_N"], one["drive2_N"])

    def test_a_wrong_row_is_refused_with_a_hint(self):
        with tempfile.TemporaryDirectory() as folder:
            model = pathlib.Path(folder) / "model.toml"
            row = (EXAMPLE / "row.toml").read_text().replace("bellows", "bellow")
            model.write_text((ROOT / "models" / "pm600-like.toml").read_text() + row)
            run = subprocess.run([PROGRAM, model], capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertIn("bellows", run.stderr)


if __name__ == "__main__":
    unittest.main()
