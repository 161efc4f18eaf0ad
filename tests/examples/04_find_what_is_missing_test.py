"""A hidden effect is found: what the example prints and writes."""

import json
import os
import pathlib
import subprocess
import tempfile
import tomllib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "04_find_what_is_missing"
CASE = ROOT / "tests" / "blind" / "open-01"


class Input(unittest.TestCase):
    def test_the_model_says_nothing_of_what_is_hidden(self):
        self.assertNotIn("effect", tomllib.loads((CASE / "base.toml").read_text()))

    def test_no_pose_to_look_at_is_among_the_measured_ones(self):
        def poses(folder):
            runs = tomllib.loads((CASE / folder / "dataset.toml").read_text())["run"]
            return {(*run["centre_mm"], *run["tilt_deg"]) for run in runs}
        self.assertFalse(poses("data") & poses("holdout"))


class WithProgram(unittest.TestCase):
    def test_it_is_named_and_the_gap_closes(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([EXAMPLE / "run", os.environ["PLUMBLINE_PROGRAM"], folder], capture_output=True, text=True)
            self.assertEqual(run.returncode, 0, run.stderr)
            read = lambda name: json.loads(pathlib.Path(folder, name).read_text())
            before, after, found = read("before.json"), read("after.json"), read("diagnosis.json")
            page = pathlib.Path(folder, "report.html").read_text()
        self.assertIn("backlash", run.stdout)
        self.assertEqual([effect["name"] for effect in found["effects"]], ["backlash"])
        # what was hidden: answers/open-01.json
        hidden = [1.99, 1.20, 0.36, 0.29, 0.60, 0.30]
        errors = found["effects"][0]["standard_errors"]["width_um"]
        for is_, value, error in zip(hidden, found["effects"][0]["parameters"]["width_um"], errors):
            self.assertLess(abs(value - is_), 0.02 + 4 * error)
        self.assertLess(after["radial_rms_um"], 0.6)  # the noise is 0.5
        self.assertLess(after["radial_rms_um"], 0.5 * before["radial_rms_um"])
        self.assertGreater(found["effects"][0]["left_out_nats"]["poses"], 10)
        directions = [c for c in found["where"]["contrasts"] if c["by"] == "direction"]
        self.assertGreater(directions[0]["differs_rms"]["radial_um"], 1.2 * found["noise"]["radial_um"])
        shown = json.loads(page.split('id="data">', 1)[1].split("</script>", 1)[0])
        self.assertIn("backlash", shown["lead"])
        titles = [section["title"] for section in shown["sections"]]
        for title in ("Found: backlash", "The gap around the circle, before and after", "Waves around the circle, before"):
            self.assertTrue(title in titles, f"{title} is not among {titles}")


if __name__ == "__main__":
    unittest.main()
