"""The table of a fleet: machines whose answers are known, and one whose measurements are no dataset."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples/10_a_fleet"
PYTHON = os.environ.get("PLUMBLINE_PYTHON", "")


class Fleet(unittest.TestCase):
    def test_each_machine_has_its_line(self):
        if not PYTHON:
            print("this test is skipped: the Python module is not built (scripts/setup --dev)")
            return
        with tempfile.TemporaryDirectory() as scratch:
            fleet = pathlib.Path(scratch, "fleet")
            for name, case in (("hex-1", "open-01"), ("hex-3", "open-03")):
                shutil.copytree(ROOT / "tests/blind" / case / "data", fleet / name)
                shutil.copy(ROOT / "tests/blind" / case / "base.toml", fleet / name / "model.toml")
            (fleet / "hex-9").mkdir()
            (fleet / "hex-9/dataset.toml").write_text("runs = 3\n")
            done = subprocess.run([sys.executable, "-B", EXAMPLE / "fleet.py", fleet, ROOT / "models/pm600-like.toml"],
                                  env={**os.environ, "PYTHONPATH": PYTHON}, capture_output=True, text=True)
        self.assertEqual(done.returncode, 1, done.stderr)
        lines = [line.split(None, 3) for line in done.stdout.splitlines()[1:]]
        self.assertEqual([line[0] for line in lines], ["hex-1", "hex-3", "hex-9"])
        self.assertEqual(lines[0][3], "backlash")
        self.assertGreater(float(lines[0][1]), 1.5 * float(lines[0][2]))
        self.assertEqual(lines[1][3], "nothing")
        self.assertIn("refused: ", done.stdout.splitlines()[3])


if __name__ == "__main__":
    unittest.main()
