#!/usr/bin/env python3
"""plumbline.exe: what it needs, and that it does as the program of this system does.

windows_test.py libraries      which DLLs plumbline.exe and plumbline.dll load
windows_test.py files          names, line ends, replaced files, interrupted runs
windows_test.py same           outputs byte for byte those of $PLUMBLINE_PROGRAM
windows_test.py batch          a folder of programs: as here, killed, watched
windows_test.py run PROGRAM... runs a test program with plumbline.exe as $PLUMBLINE_PROGRAM
"""
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import wine

ROOT = Path(__file__).resolve().parents[2]
MODEL = str(ROOT / "models/pm600-like.toml")
OF_WINDOWS = {"kernel32.dll", "msvcrt.dll", "shell32.dll", "advapi32.dll", "user32.dll"}
PART = "(PART)\nG21 G90 G94\nG0 X0 Y0 Z5 A0 B0 C0\nG1 Z0 F500\nG1 X20.5 Y10.25 A5 B-2.5 C1\nG2 X30.5 Y20.25 I5 J5\nM2\n"
OPTIONS = ["-m", MODEL, "--work-offset", "G54=0,0,-1008,0,0,0"]


def loaded(path):
    text = subprocess.run(["x86_64-w64-mingw32-objdump", "-p", path], capture_output=True, text=True, check=True).stdout
    return {name.lower() for name in re.findall(r"DLL Name: (\S+)", text)}


class Libraries(unittest.TestCase):
    def test_of_the_system_alone(self):
        if not wine.EXE.exists():
            wine.skip(f"there is no {wine.EXE} (cmake --preset windows && cmake --build --preset windows)")
        for path in (wine.EXE, wine.BUILD / "plumbline.dll"):
            names = loaded(path)
            self.assertIn("kernel32.dll", names, path)
            self.assertLessEqual(names, OF_WINDOWS, path)

    def test_what_the_library_shows(self):
        if not wine.EXE.exists():
            wine.skip(f"there is no {wine.EXE} (cmake --preset windows && cmake --build --preset windows)")
        text = subprocess.run(["x86_64-w64-mingw32-objdump", "-p", wine.BUILD / "plumbline.dll"], capture_output=True,
                              text=True, check=True).stdout
        shown = set(re.findall(r"^\s*\[\s*\d+\]\s+\+base\[\s*\d+\]\s+[0-9a-f]+ (\S+)$", text, re.M)) or set(
            re.findall(r"^\s*\[\s*\d+\] (\S+)$", text, re.M))
        header = (ROOT / "include/plumbline/plumbline.h").read_text()
        asked = set(re.findall(r"\b(plumbline_\w+)\(", header))
        self.assertGreater(len(asked), 5)
        self.assertLessEqual(asked, shown)


class UnderWine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.environment = wine.require()

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="plumbline-windows-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.exe = wine.wrapper(tempfile.mkdtemp(dir=self.folder))

    def run_exe(self, *words, **others):
        return subprocess.run([self.exe, *map(str, words)], cwd=self.folder, env=self.environment, capture_output=True,
                              timeout=300, **others)

    def run_here(self, *words, **others):
        return subprocess.run([os.environ["PLUMBLINE_PROGRAM"], *map(str, words)], cwd=self.folder, capture_output=True,
                              timeout=300, **others)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())
        return path


class Files(UnderWine):
    def test_names_are_any_letters(self):
        for name in ("Gehäuse Größe.ngc", "部品.ngc", "Ülà/Деталь.ngc", "smile \U0001f600.ngc"):
            with self.subTest(name=name):
                self.write(name, PART)
                done = self.run_exe("compensate", name, "-o", f"aus-{Path(name).name}", *OPTIONS)
                self.assertEqual(done.returncode, 0, done.stderr.decode())
                self.assertTrue((self.folder / f"aus-{Path(name).name}").exists())
        missing = self.run_exe("trace", "fehlt-ö-字.ngc")
        self.assertEqual(missing.returncode, 1)
        self.assertIn("fehlt-ö-字.ngc: error: cannot be opened: No such file or directory", missing.stderr.decode())

    def test_line_ends_are_kept(self):
        self.write("crlf.ngc", PART.replace("\n", "\r\n"))
        self.assertEqual(self.run_exe("compensate", "crlf.ngc", "-o", "out.ngc", "--undo", *OPTIONS).returncode, 0)
        out = (self.folder / "out.ngc").read_bytes()
        self.assertEqual(out.count(b"\n"), out.count(b"\r\n"))
        self.assertGreater(out.count(b"\r\n"), 10)
        self.write("lf.ngc", PART)
        self.assertEqual(self.run_exe("compensate", "lf.ngc", "-o", "lf-out.ngc", *OPTIONS).returncode, 0)
        self.assertNotIn(b"\r", (self.folder / "lf-out.ngc").read_bytes())
        self.assertEqual(self.run_exe("restore", "out.ngc", "-o", "-").stdout, PART.replace("\n", "\r\n").encode())

    def test_streams_carry_bytes(self):
        self.write("crlf.ngc", PART.replace("\n", "\r\n"))
        self.assertEqual(self.run_exe("compensate", "crlf.ngc", "-o", "out.ngc", *OPTIONS).returncode, 0)
        piped = self.run_exe("compensate", "-", "-o", "-", *OPTIONS, input=PART.replace("\n", "\r\n").encode())
        self.assertEqual(piped.stdout, (self.folder / "out.ngc").read_bytes())
        ends = self.run_exe("trace", "-", input=b"G0 X1\x1aY2\n")  # Ctrl-Z ends nothing
        self.assertEqual(ends.returncode, 1)

    def test_a_file_is_replaced_and_nothing_else_is_left(self):
        self.write("part.ngc", PART)
        self.write("out.ngc", "old")
        before = {path.name for path in self.folder.iterdir()}
        self.assertEqual(self.run_exe("compensate", "part.ngc", "-o", "out.ngc", *OPTIONS).returncode, 0)
        self.assertIn(b"plumbline", (self.folder / "out.ngc").read_bytes())
        self.assertEqual({path.name for path in self.folder.iterdir()}, before)
        refused = self.run_exe("compensate", "part.ngc", "-o", "part.ngc", *OPTIONS)
        self.assertEqual(refused.returncode, 1)
        self.assertIn(b"would overwrite the input", refused.stderr)
        self.assertEqual((self.folder / "part.ngc").read_bytes(), PART.encode())

    def test_a_program_and_its_undo_file_are_replaced(self):
        self.write("part.ngc", PART)
        for _ in range(2):
            done = self.run_exe("compensate", "part.ngc", "-o", "out.ngc", "--undo", *OPTIONS)
            self.assertEqual(done.returncode, 0, done.stderr.decode())
        self.assertEqual(self.temporary_files(), [])
        self.assertEqual(self.run_exe("restore", "out.ngc", "-o", "-").stdout, PART.encode())

    def test_a_read_only_file_is_not_replaced(self):
        self.write("part.ngc", PART)
        self.write("out.ngc", "old").chmod(0o444)
        refused = self.run_exe("compensate", "part.ngc", "-o", "out.ngc", *OPTIONS)
        self.assertEqual(refused.returncode, 1)
        self.assertIn(b"is read-only", refused.stderr)
        self.assertIn(b"attrib -r", refused.stderr)
        self.assertEqual((self.folder / "out.ngc").read_bytes(), b"old")

    def temporary_files(self):
        return [path for path in self.folder.iterdir() if path.name.startswith(".plumbline-")]

    def interrupted(self, by):
        """A run that waits for standard input, with a temporary file made, and is then ended."""
        process = subprocess.Popen([wine.WINE, wine.EXE, "compensate", "long.ngc", "-o", "out.ngc", *OPTIONS,
                                    "--step-length", "0.001"],
                                   cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + 120
        while not self.temporary_files() and time.monotonic() < end and process.poll() is None:
            time.sleep(0.02)
        self.assertTrue(self.temporary_files())
        process.send_signal(by)
        process.wait(timeout=120)
        return process.returncode

    def write_long(self):
        lines = "".join(f"G1 X{i % 7}.5 Y{i % 3}\n" for i in range(20_000))
        self.write("long.ngc", "G21 G90 G94\nG0 X0 Y0 Z5 A0 B0 C0\nF1000\n" + lines + "M2\n")

    def test_ctrl_c_removes_temporary_files(self):
        self.write_long()
        self.assertNotEqual(self.interrupted(signal.SIGINT), 0)
        self.assertEqual(self.temporary_files(), [])
        self.assertFalse((self.folder / "out.ngc").exists())

    def test_what_a_killed_run_left_is_swept(self):
        self.write_long()
        self.interrupted(signal.SIGKILL)
        self.assertEqual(len(self.temporary_files()), 1)
        self.write("part.ngc", PART)
        self.assertEqual(self.run_exe("trace", "part.ngc", "-o", "moves.jsonl").returncode, 0)
        self.assertEqual(self.temporary_files(), [])


class Same(UnderWine):
    """What both programs write."""

    def assert_same(self, *words):
        with self.subTest(words=words):
            here, there = self.run_here(*words), self.run_exe(*words)
            self.assertEqual(here.returncode, 0, here.stderr.decode())
            self.assertEqual((there.returncode, there.stdout), (here.returncode, here.stdout), there.stderr.decode())
            return here.stdout

    def files_of(self, folder):
        return {path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}

    def assert_same_folder(self, *words):
        for name, run in (("here", self.run_here), ("there", self.run_exe)):
            done = run(*words, "-o", "results")
            self.assertEqual(done.returncode, 0, done.stderr.decode())
            (self.folder / "results").rename(self.folder / name)
        here, there = self.files_of(self.folder / "here"), self.files_of(self.folder / "there")
        self.assertEqual(sorted(here), sorted(there))
        for name, text in here.items():
            self.assertEqual(there[name], text, name)
        return self.folder / "here"

    def test_programs_of_every_kind(self):
        self.write("part.ngc", PART)
        self.assert_same("compensate", "part.ngc", "-o", "-", *OPTIONS)
        self.assert_same("compensate", "part.ngc", "-o", "-", "--tolerance", "1um", *OPTIONS)
        self.assert_same("trace", "part.ngc")
        self.assert_same("check", "part.ngc", "--json", "-", *OPTIONS)
        self.assert_same("simulate", "part.ngc", *OPTIONS)
        self.assert_same("map", "-m", MODEL)

    def test_the_programs_of_the_tests(self):
        programs = sorted((ROOT / "tests/fuzz/corpus").rglob("*.ngc")) + sorted((ROOT / "tests/install").rglob("*.ngc"))
        self.assertGreater(len(programs), 3)
        for program in programs:
            with self.subTest(program=program.name):
                words = ("compensate", program, "-o", "-", *OPTIONS, "--no-settings")
                here, there = self.run_here(*words), self.run_exe(*words)
                self.assertEqual((there.returncode, there.stdout), (here.returncode, here.stdout), there.stderr.decode())

    def test_measurements(self):
        plan = self.assert_same_folder("plan", "-m", MODEL)
        self.assertTrue((plan / "dataset.toml").exists())


class Batch(UnderWine):
    """A folder of programs."""

    PROGRAMS = 60
    PATIENCE = 120

    def setUp(self):
        super().setUp()
        self.names = [f"{i % 3}/Teil-{i:03}.nc" for i in range(self.PROGRAMS)]
        for i, name in enumerate(self.names):
            self.write(f"parts/{name}", PART.replace("B-2.5", f"B-2.{i}").replace("\n", "\r\n"))
        self.words = ["batch", "parts", *OPTIONS]

    def texts(self, folder):
        return {path.relative_to(self.folder / folder).as_posix(): path.read_bytes()
                for path in sorted((self.folder / folder).rglob("*.nc"))}

    def states(self, name):
        return [json.loads(line).get("state") for line in (self.folder / name).read_text().splitlines()]

    def wait_for(self, is_there):
        end = time.monotonic() + self.PATIENCE
        while not is_there():
            self.assertLess(time.monotonic(), end, "it does not come")
            time.sleep(0.05)

    def test_as_here_and_again(self):
        here = self.run_here(*self.words, "-o", "here")
        self.assertEqual(here.returncode, 0, here.stderr.decode())
        there = self.run_exe(*self.words, "-o", "there", "--json", "first.jsonl")
        self.assertEqual(there.returncode, 0, there.stderr.decode())
        self.assertEqual(sorted(self.texts("here")), sorted(self.names))
        self.assertEqual(self.texts("there"), self.texts("here"))
        self.assertEqual(self.states("first.jsonl").count("done"), self.PROGRAMS)
        self.write(f"parts/{self.names[7]}", PART)
        again = self.run_exe(*self.words, "-o", "there", "--json", "again.jsonl")
        self.assertEqual(again.returncode, 0, again.stderr.decode())
        self.assertEqual(self.states("again.jsonl").count("unchanged"), self.PROGRAMS - 1)
        self.assertEqual(self.states("again.jsonl").count("done"), 1)

    def test_killed_and_run_again(self):
        self.assertEqual(self.run_here(*self.words, "-o", "here").returncode, 0)
        expected = self.texts("here")
        running = subprocess.Popen([wine.WINE, wine.EXE, *self.words, "-o", "out"], cwd=self.folder,
                                   env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.wait_for(lambda: (self.folder / "out").exists() and list((self.folder / "out").rglob("*")))
        running.kill()
        running.wait(self.PATIENCE)
        for name, text in self.texts("out").items():
            self.assertEqual(text, expected[name])
        done = self.run_exe(*self.words, "-o", "out")
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        self.assertEqual(self.texts("out"), expected)
        self.assertEqual([path.name for path in (self.folder / "out").rglob(".plumbline-*.tmp")], [])

    def test_watched(self):
        running = subprocess.Popen([wine.WINE, wine.EXE, *self.words, "-o", "out", "--watch", "--poll", "0.5"],
                                   cwd=self.folder, env=self.environment, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        self.addCleanup(running.wait)
        self.addCleanup(running.kill)
        self.wait_for(lambda: len(self.texts("out")) == self.PROGRAMS)
        self.write("parts/neu/späť.nc", PART)
        self.wait_for(lambda: "neu/späť.nc" in self.texts("out"))
        running.send_signal(signal.SIGINT)
        self.assertNotEqual(running.wait(self.PATIENCE), 0)


if __name__ == "__main__":
    if sys.argv[1] == "run":
        environment = wine.require()
        with tempfile.TemporaryDirectory() as scratch:
            environment["PLUMBLINE_PROGRAM"] = str(wine.wrapper(scratch))
            sys.exit(subprocess.run(sys.argv[2:], env=environment).returncode)
    suites = {"libraries": Libraries, "files": Files, "same": Same, "batch": Batch}
    case = unittest.defaultTestLoader.loadTestsFromTestCase(suites[sys.argv[1]])
    sys.exit(not unittest.TextTestRunner(verbosity=2).run(case).wasSuccessful())
