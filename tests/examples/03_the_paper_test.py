"""The paper's experiments on the stand-in: its figures are reached, and the plots are there."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "03_the_paper"
sys.path.insert(0, str(EXAMPLE))
import polar_plot  # noqa: E402


class Input(unittest.TestCase):
    def test_set_up_is_taken_out_of_a_profile(self):
        angles = [360 * i / 72 for i in range(72)]
        profile = [5 + 3 * polar_plot.math.cos(polar_plot.math.radians(a)) for a in angles]
        self.assertLess(max(abs(r) for r in polar_plot.centred(angles, profile)), 1e-12)
        ellipse = [r + polar_plot.math.sin(polar_plot.math.radians(2 * a)) for a, r in zip(angles, profile)]
        self.assertAlmostEqual(max(polar_plot.centred(angles, ellipse)), 1, places=12)

    def test_rings_suit_the_largest_deviation(self):
        self.assertEqual([polar_plot.nice_step(x) for x in (3, 8, 80, 210)], [1, 2, 20, 100])


class WithProgram(unittest.TestCase):
    def test_the_paper_s_figures_are_reached(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([EXAMPLE / "run", os.environ["PLUMBLINE_PROGRAM"], os.environ["PLUMBLINE_DRAW_CASE"],
                                  folder], capture_output=True, text=True)
            self.assertEqual(run.returncode, 0, run.stderr)
            summary = json.loads(pathlib.Path(folder, "summary.json").read_text())
            for name in ("fig7a", "fig7b", "fig9a", "fig9b"):
                plot = xml.etree.ElementTree.parse(pathlib.Path(folder, f"{name}.svg"))
                self.assertEqual(len(plot.findall("{http://www.w3.org/2000/svg}polygon")), 2)
        before, after = summary["before_um"], summary["after_um"]
        self.assertEqual(len(before), 8)
        self.assertGreater(before["a-25"], 150)  # the machine sags as the paper's did
        self.assertGreater(before["a-17-b-17"], 100)
        self.assertLess(after["a-25"], (1 - 0.779) * before["a-25"])
        self.assertLess(after["a-17-b-17"], (1 - 0.694) * before["a-17-b-17"])
        self.assertTrue(all(after[name] < before[name] for name in before))
        self.assertLess(summary["torque_mean_abs_Nm"]["a"], 0.06)
        self.assertLess(summary["torque_mean_abs_Nm"]["b"], 0.06)
        self.assertLess(summary["profile_rms_um"]["a-23"], 1.5)
        self.assertLess(summary["profile_rms_um"]["a-17-b-17"], 10)
        self.assertIn("200.6", run.stdout)


if __name__ == "__main__":
    unittest.main()
