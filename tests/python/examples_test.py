"""examples/08_from_python, and the examples of docs/library.md in Python."""
import contextlib
import io
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy  # noqa: F401
except ModuleNotFoundError as missing:
    print(f"this test is skipped: {missing} (scripts/setup --dev)")
    sys.exit(77)

import plumbline

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples/08_from_python"
MODEL = ROOT / "models/pm600-like.toml"
PROGRAM = ROOT / "tests/install/outside/part.ngc"
OFFSET = {"G54": (0, 0, -1008, 0, 0, 0)}
sys.path.insert(0, str(EXAMPLE))


class FreecadPost(unittest.TestCase):
    def export(self, objects, filename, arguments):
        """Stands for FreeCAD's post: string out, and nothing saved for "-"."""
        self.assertEqual((objects, filename, arguments), (["Job"], "-", "--no-header"))
        return PROGRAM.read_text()

    def test_what_the_post_exports_is_straightened_and_saved(self):
        from freecad_post import straightened

        straight = straightened(self.export, MODEL, work_offset=OFFSET)
        expected = plumbline.compensate(PROGRAM, MODEL, work_offset=OFFSET).text
        with tempfile.TemporaryDirectory() as folder:
            saved = Path(folder) / "part.ngc"
            self.assertEqual(straight(["Job"], str(saved), "--no-header"), expected)
            self.assertEqual(saved.read_text(), expected)

    def test_what_is_refused_is_not_saved(self):
        from freecad_post import straightened

        with tempfile.TemporaryDirectory() as folder:
            saved = Path(folder) / "part.ngc"
            with self.assertRaises(plumbline.Refused) as caught:
                straightened(lambda *_: "G0 X0 Y0 Z0 A0 B0 C0\nG1 A60 F100\n", MODEL,
                             work_offset=OFFSET)(["Job"], str(saved))
            self.assertEqual(caught.exception.file, str(saved))
            self.assertFalse(saved.exists())
            saved.write_text("an earlier export")
            with self.assertRaises(plumbline.Refused):
                straightened(lambda *_: "", MODEL, work_offset=OFFSET)(["Job"], str(saved))
            self.assertEqual(saved.read_text(), "an earlier export")

    def test_warnings_are_shown(self):
        from freecad_post import straightened

        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            straightened(lambda *_: PROGRAM.read_text(), MODEL, work_offset=OFFSET, step_length=0.001)(["Job"], "-")
        self.assertRegex(said.getvalue(), r"-:\d+: warning: .* shorter than 1 ms, .*\nhelp: ")

    def test_what_cannot_be_saved_leaves_nothing(self):
        from freecad_post import save

        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "part.ngc").mkdir()
            with self.assertRaises(OSError):
                save(b"G0", str(Path(folder) / "part.ngc"))
            self.assertEqual([path.name for path in Path(folder).iterdir()], ["part.ngc"])


class Notebook(unittest.TestCase):
    def run_script(self, *more):
        return subprocess.run([sys.executable, "-B", EXAMPLE / "error_along_a_program.py", PROGRAM, MODEL, *more],
                              capture_output=True, text=True, check=True).stdout

    def test_the_numbers(self):
        said = self.run_script()
        self.assertRegex(said, r"before: the tip up to \d\d\.\d um off\n"
                               r"corrected by up to \d\d\.\d um, at most \d+\.\d\d um are left\n"
                               r"at Z-1008 the tip sags by \d+\.\d to \d+\.\d um\n")

    def test_the_picture(self):
        try:
            import matplotlib  # noqa: F401
        except ModuleNotFoundError:
            self.skipTest("matplotlib is not installed (python3-matplotlib)")
        with tempfile.TemporaryDirectory() as folder:
            picture = Path(folder) / "error.png"
            self.run_script(picture)
            self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))


class Documented(unittest.TestCase):
    def test_the_page_runs_from_its_first_line_to_its_last(self):
        page = (ROOT / "docs/library.md").read_text()
        blocks = re.findall(r"^```python\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
        self.assertGreaterEqual(len(blocks), 1)
        with tempfile.TemporaryDirectory() as folder:
            for name in (MODEL, PROGRAM):
                (Path(folder) / name.name).write_bytes(name.read_bytes())
            done = subprocess.run([sys.executable, "-B", "-c", "\n".join(blocks)], cwd=folder, capture_output=True,
                                  text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("limit-tilt in line 2", done.stdout)
            expected = plumbline.compensate(PROGRAM, MODEL, work_offset=OFFSET)
            self.assertEqual((Path(folder) / "straight.ngc").read_text(), expected.text)


if __name__ == "__main__":
    unittest.main()
