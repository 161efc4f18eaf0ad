"""A control runs the example: its program (Input), and what LinuxCNC and the stand-in make of it (WithProgram, where
LinuxCNC is installed and none is running)."""

import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "06_on_a_control"
sys.path[:0] = [str(EXAMPLE), str(ROOT / "src" / "jobs")]
import control  # noqa: E402
import deviation_plot  # noqa: E402
import linuxcnc_view  # noqa: E402
import make_program  # noqa: E402


class Input(unittest.TestCase):
    def test_the_view_draws_struts_that_are_as_long_as_the_formula_says(self):
        model = tomllib.loads((ROOT / "models" / "pm600-like.toml").read_text())
        tip_mm = model["platform"]["tool_tip_mm"]
        platform = [[p - t for p, t in zip(joint, tip_mm)] for joint in model["platform"]["joints_mm"]]
        # the control's Z contains the tool
        tip, spindle, joints = linuxcnc_view.stand((11, -20, -1003 + 85, 10, -12, 7), 85, platform)
        self.assertEqual(tip, (11, -20, -1003))
        self.assertAlmostEqual(math.dist(tip, spindle), 85)
        words = {"A": 10, "B": -12, "C": 7}
        for base, joint, length in zip(model["base"]["joints_mm"], joints, strut_lengths(model, 85, tip, words)):
            self.assertAlmostEqual(math.dist(base, joint), length, places=9)

    def test_every_block_of_the_wave_states_six_axes_within_the_tilt(self):
        wave = [line for line in make_program.program().splitlines() if line.startswith("X")]
        self.assertEqual(len(wave), make_program.BLOCKS)
        for line in wave:
            words = {axis: float(value) for axis, value in re.findall(r"([XYZABC])(-?[\d.]+)", line)}
            self.assertEqual(set(words), set("XYZABC"))
            tilt = math.acos(math.cos(math.radians(words["A"])) * math.cos(math.radians(words["B"])))
            self.assertLess(math.degrees(tilt), 25)
        self.assertEqual(wave[-1].replace("-0.0000", "0.0000"), "X59.0000 Y0.0000 Z0.0000 A0.0000 B-19.0000 C0.0000")

    def test_a_plot_keeps_the_largest_deviation(self):
        rows = [(i / 1000, 7.5 if i == 4321 else 0.1) for i in range(20000)]
        thin = deviation_plot.thinned(rows)
        self.assertEqual(len(thin), deviation_plot.PIECES)
        self.assertIn((4.321, 7.5), thin)
        self.assertEqual(deviation_plot.decades([0.12, 7.5]), (-1, 1))

    def test_lost_samples_are_no_samples(self):
        self.assertEqual(control.whole("overrun\n7 1\n8 1\n"), "7 1\n8 1\n")
        with self.assertRaises(control.ControlError):
            control.whole("7 1\noverrun\n9 1\n")


def turned(words, arm):
    """R arm, R = Rz(C) Ry(B) Rx(A)."""
    a, b, c = (math.radians(words[axis]) for axis in "ABC")
    x, y, z = arm
    y, z = math.cos(a) * y - math.sin(a) * z, math.sin(a) * y + math.cos(a) * z
    x, z = math.cos(b) * x + math.sin(b) * z, -math.sin(b) * x + math.cos(b) * z
    return math.cos(c) * x - math.sin(c) * y, math.sin(c) * x + math.cos(c) * y, z


def strut_lengths(model, tool_mm, tip, words):
    """Of a machine whose tip (mm in W) and A, B, C are these, its tool along -Z of the platform."""
    of_tip = (*model["platform"]["tool_tip_mm"][:2], model["platform"]["tool_tip_mm"][2] - tool_mm)
    for base, joint in zip(model["base"]["joints_mm"], model["platform"]["joints_mm"]):
        arm = turned(words, [p - q for p, q in zip(joint, of_tip)])
        yield math.dist([t + r for t, r in zip(tip, arm)], base)


def skips_without_control():
    why_not = control.missing()
    if why_not:
        print(f"\nthis test is skipped: {why_not}")
    return bool(why_not)


class WithProgram(unittest.TestCase):
    def test_the_control_s_struts_are_as_long_as_the_formula_says(self):
        if skips_without_control():
            return
        model = ROOT / "models" / "pm600-like.toml"
        tools = ROOT / "examples" / "01_compensate_a_program" / "tools.toml"
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([os.environ["PLUMBLINE_PROGRAM"], "control", "linuxcnc", "-m", model, "--tools", tools,
                            "--work-offset", "G55=0,0,-1008,0,0,0", "-o", f"{folder}/control"], check=True,
                           stderr=subprocess.DEVNULL)
            program = pathlib.Path(folder, "pose.ngc")
            program.write_text("G21 G90 G94 G55\nT1 M6\nG43 H1\nG0 X10 Y-20 Z5 A10 B-12 C7\nG1 X11 F600\nM2\n")
            (recording,) = control.run(f"{folder}/control", [program], folder)
            sampled = [float(word) for word in recording.read_text().splitlines()[-1].split()[1:7]]
        words = {"A": 10, "B": -12, "C": 7}
        expected = strut_lengths(tomllib.loads(model.read_text()), 85, (11, -20, 5 - 1008), words)
        for length, is_ in zip(expected, sampled):
            self.assertAlmostEqual(is_, length, delta=2e-6)  # mm; the recording has six decimals

    def test_the_compensated_program_brings_the_tip_to_the_path_in_the_same_time(self):
        if skips_without_control():
            return
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([EXAMPLE / "run", os.environ["PLUMBLINE_PROGRAM"], os.environ["PLUMBLINE_PLAY_JOINTS"],
                                  folder], capture_output=True, text=True)
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
            summary = json.loads(pathlib.Path(folder, "summary.json").read_text())
            for machine in summary:
                plot = xml.etree.ElementTree.parse(pathlib.Path(folder, f"{machine}.svg"))
                self.assertEqual(len(plot.findall("{http://www.w3.org/2000/svg}polyline")), 2)
        for machine, most, rms in (("bends", 3, 0.3), ("rubs", 12, 1), ("remembers", 14, 0.6)):
            before, after = summary[machine]["programmed"], summary[machine]["compensated"]
            self.assertGreater(before["most_um"], 100)  # the machine bends by what is worth correcting
            self.assertLess(after["most_um"], most)
            self.assertLess(after["rms_um"], rms)
            self.assertLess(abs(after["seconds"] / before["seconds"] - 1), 0.01)
            self.assertGreater(after["samples"], 20000)
        self.assertIn("as programmed", run.stdout)


if __name__ == "__main__":
    unittest.main()
