"""The first example: its generated program (Input), and what plumbline makes of it (WithProgram, in $PLUMBLINE_PROGRAM).

Nothing here shares code with plumbline: words are read by a few regular expressions, limits computed from them, and
where LinuxCNC's interpreter is installed, it runs both programs."""

import collections
import functools
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "01_compensate_a_program"
OFFSET_Z = -1008.0
AXES = "XYZABC"


def generate():
    command = [sys.executable, "-B", EXAMPLE / "make_program.py"]
    return subprocess.run(command, capture_output=True, check=True).stdout


def positions(program):
    """(G code of the motion, feed mode, words) of each block that moves, modal G codes followed."""
    motion, feed_mode = None, None
    for line in program.splitlines():
        if line.startswith(("(", "%")):
            continue
        for code in re.findall(r"G(\d+)", line):
            motion = code if code in ("0", "1", "2", "3") else motion
            feed_mode = code if code in ("93", "94") else feed_mode
        words = {letter: float(value) for letter, value in re.findall(r"([A-Z])(-?[\d.]+)", line)}
        if any(axis in words for axis in AXES):
            yield motion, feed_mode, words


def tilt_deg(words):
    # Z of P in W, R = Rz(C) Ry(B) Rx(A): its third component is cos A cos B
    return math.degrees(math.acos(math.cos(math.radians(words["A"])) * math.cos(math.radians(words["B"]))))


def comments(program):
    return re.findall(r"^\(.*\)$", program, re.MULTILINE)


def block_ends(program):
    """Where all six axes stand after each numbered block, the pieces after it (which have no number) included."""
    ends, at, number = {}, {}, None
    for line in program.splitlines():
        if line.startswith(("(", "%")):
            continue
        words = dict(re.findall(r"([A-Z])(-?[\d.]+)", line))
        number = words.get("N", number)
        at = at | {axis: float(words[axis]) for axis in AXES if axis in words}
        ends[number] = at
    return ends


def run_in_linuxcnc(program):
    """The canonical commands that LinuxCNC's own interpreter makes of it."""
    tool = tomllib.loads((EXAMPLE / "tools.toml").read_text())["tool"][0]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "program.ngc").write_bytes(program)
        (folder / "vars.var").touch()
        # the tables of this stand-alone interpreter are in inches
        (folder / "tools.tbl").write_text(f"T{tool['number']} P1 Z{tool['length_mm'] / 25.4:.9f}\n")
        command = ["rs274", "-g", "-n", "2", "-t", "tools.tbl", "-v", "vars.var", "program.ngc", "canon"]
        environment = {"PATH": "/usr/bin:/bin", "HOME": str(folder)}
        run = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
        assert run.returncode == 0, run.stderr
        return (folder / "canon").read_text()


def needs_rs274(test):
    """Skips a test where LinuxCNC's interpreter is not installed, and says so where scripts/test looks for it."""

    @functools.wraps(test)
    def run(self):
        if not shutil.which("rs274"):
            print("\nthis part is skipped: LinuxCNC's interpreter is not installed (scripts/setup --dev --with-oracle)")
            self.skipTest("no rs274")
        test(self)

    return run


class Input(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.bytes = generate()
        cls.program = cls.bytes.decode("ascii")
        cls.moves = list(positions(cls.program))

    def test_same_bytes_at_every_run(self):
        self.assertEqual(self.bytes, generate())

    def test_is_as_large_and_varied_as_promised(self):
        kinds = collections.Counter((motion, mode) for motion, mode, _ in self.moves)
        self.assertGreaterEqual(sum(kinds.values()), 5000)
        self.assertGreater(kinds["1", "94"], 3000)
        self.assertGreater(kinds["1", "93"], 1000)
        self.assertGreater(kinds["2", "94"], 10)
        self.assertGreater(kinds["3", "94"], 10)
        self.assertGreater(kinds["0", "94"], 10)

    def test_every_move_states_all_six_axes(self):
        for _, _, words in self.moves:
            self.assertTrue(all(axis in words for axis in AXES), words)

    def test_cutting_moves_all_six_axes_at_once(self):
        cuts = together = 0
        for (_, _, before), (motion, _, words) in zip(self.moves, self.moves[1:]):
            if motion == "0":
                continue
            cuts += 1
            together += all(before[axis] != words[axis] for axis in AXES)
        self.assertGreater(together, 0.97 * cuts)

    def test_inverse_time_states_its_feed_in_every_block(self):
        for motion, mode, words in self.moves:
            if mode == "93" and motion != "0":
                self.assertGreater(words["F"], 0)

    def test_keeps_to_the_limits_of_the_machine(self):
        limits = tomllib.loads((ROOT / "models" / "pm600-like.toml").read_text())["limits"]
        for _, _, words in self.moves:
            self.assertLessEqual(tilt_deg(words), 15.0)
            self.assertLessEqual(max(abs(words["X"]), abs(words["Y"])), 110.0)
            self.assertTrue(limits["z_mm"][0] < words["Z"] + OFFSET_Z < limits["z_mm"][1], words)
        self.assertLess(15.0, limits["tilt_deg"])

    @needs_rs274
    def test_runs_in_the_interpreter_of_linuxcnc(self):
        canon = run_in_linuxcnc(self.bytes)
        made = collections.Counter(re.findall(r"\b(STRAIGHT_TRAVERSE|STRAIGHT_FEED|ARC_FEED)\(", canon))
        counted = collections.Counter(motion for motion, _, _ in self.moves)
        self.assertEqual(made["STRAIGHT_TRAVERSE"], counted["0"])
        self.assertEqual(made["STRAIGHT_FEED"], counted["1"])
        self.assertEqual(made["ARC_FEED"], counted["2"] + counted["3"])


class WithProgram(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.out = pathlib.Path(folder.name)
        cls.plumbline = os.environ["PLUMBLINE_PROGRAM"]
        run = subprocess.run([EXAMPLE / "run", cls.plumbline, cls.out], capture_output=True, text=True)
        if run.returncode != 0:
            raise AssertionError(f"exit code {run.returncode}\n{run.stdout}\n{run.stderr}")
        cls.source = (cls.out / "crown.ngc").read_text()
        cls.compensated = (cls.out / "crown-compensated.ngc").read_text()
        cls.bound = (cls.out / "crown-bound.ngc").read_text()

    def diff(self, other):
        command = [self.plumbline, "diff", self.out / "crown.ngc", self.out / other, "--expect-equal"]
        return subprocess.run(command, capture_output=True).returncode

    def test_summaries_are_json(self):
        for name in ("compensate.json", "bound.json", "diff.json"):
            self.assertIsInstance(json.loads((self.out / name).read_text()), dict)

    def test_comments_and_block_numbers_survive_in_order(self):
        kept = [comment for comment in comments(self.compensated) if comment in set(comments(self.source))]
        self.assertEqual(kept, comments(self.source))
        self.assertEqual(re.findall(r"^N\d+", self.compensated, re.M), re.findall(r"^N\d+", self.source, re.M))

    def test_every_block_end_is_moved_by_microns_to_tenths(self):
        before, after = block_ends(self.source), block_ends(self.compensated)
        self.assertEqual(before.keys(), after.keys())
        shifts = []
        for number, end in before.items():
            moved = {axis: abs(after[number][axis] - end[axis]) for axis in end}
            self.assertLess(max([moved.get(axis, 0) for axis in "XYZ"]), 1.0, f"N{number}")
            self.assertLess(max([moved.get(axis, 0) for axis in "ABC"]), 0.2, f"N{number}")
            shifts.append(max(moved.values(), default=0))
        self.assertGreater(sorted(shifts)[len(shifts) // 10], 0.002)

    def test_diff_tells_them_apart(self):
        self.assertEqual(self.diff("crown.ngc"), 0)
        self.assertEqual(self.diff("crown-compensated.ngc"), 3)

    def test_a_tolerance_takes_a_fifth_of_the_points_and_no_short_block(self):
        steps, bound = (json.loads((self.out / name).read_text()) for name in ("compensate.json", "bound.json"))
        self.assertIsNone(steps["bound"])
        self.assertLess(bound["points"], steps["points"] / 5)
        self.assertEqual(bound["short_pieces"]["below_1_ms"], 0)
        self.assertLess(len(self.bound), 2.2 * len(self.source))
        self.assertEqual(bound["bound"]["not_kept_for_block_time"]["pieces"], 0)
        self.assertLess(bound["bound"]["not_kept_where_friction_turns"]["time_s"], 0.02 * bound["time_after_s"])
        self.assertLessEqual(bound["bound"]["kept_um"]["value"], 0.5)
        self.assertEqual(self.diff("crown-bound.ngc"), 3)
        before, after = block_ends(self.source), block_ends(self.bound)
        self.assertEqual(before.keys(), after.keys())

    def test_is_not_compensated_twice(self):
        again = self.out / "again.ngc"
        command = [self.plumbline, "compensate", self.out / "crown-compensated.ngc", "-m", ROOT / "models/pm600-like.toml",
                   "-o", again, "--work-offset", "G54=0,0,-1008,0,0,0", "--tools", EXAMPLE / "tools.toml"]
        self.assertEqual(subprocess.run(command, capture_output=True).returncode, 1)
        self.assertFalse(again.exists())

    @needs_rs274
    def test_result_runs_in_the_interpreter_of_linuxcnc(self):
        canon = run_in_linuxcnc(self.compensated.encode())
        self.assertGreater(canon.count("STRAIGHT_FEED("), 12000)
        self.assertGreater(run_in_linuxcnc(self.bound.encode()).count("STRAIGHT_FEED("), 12000)


if __name__ == "__main__":
    unittest.main()
