"""`plumbline batch --watch`: a CAM system exports, and the corrected program is there."""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import folders

PATIENCE = 60


class Watch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        folders.make(self.folder / "export", 1)
        an_hour_ago = time.time() - 3600
        os.utime(self.folder / "export/000/part-00000.nc", (an_hour_ago, an_hour_ago))

    def start(self, *words):
        running = subprocess.Popen([folders.PLUMBLINE, "batch", "export", "-o", "out", "--watch", *words],
                                   cwd=self.folder, env=folders.ENVIRONMENT, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(running.stderr.close)
        self.addCleanup(running.stdout.close)
        self.addCleanup(running.wait)
        self.addCleanup(running.kill)
        self.wait_for(lambda: (self.folder / "out/000/part-00000.nc").exists())
        return running

    def wait_for(self, is_there):
        end = time.monotonic() + PATIENCE
        while not is_there():
            self.assertLess(time.monotonic(), end, "it does not come")
            time.sleep(0.02)

    def read_until(self, running, words):
        line = " "
        while line and words not in line:
            line = running.stderr.readline()
        self.assertIn(words, line)

    def exports(self):
        """A program that is written slowly, in pieces that are programs by themselves, then one in a new folder."""
        text = folders.program(7, moves=40)
        with open(self.folder / "export/slow.nc", "w") as file:
            for line in text.splitlines(keepends=True):
                file.write(line)
                file.flush()
                time.sleep(0.02)
        self.wait_for(lambda: (self.folder / "out/slow.nc").exists())
        first = (self.folder / "out/slow.nc").read_text()
        (self.folder / "export/new").mkdir()
        (self.folder / "export/new/.part").write_text(folders.program(8))
        (self.folder / "export/new/.part").rename(self.folder / "export/new/b.nc")
        self.wait_for(lambda: (self.folder / "out/new/b.nc").exists())
        once = folders.batch("export", "-o", "once", cwd=self.folder)
        self.assertEqual(once.returncode, 0, once.stderr)
        self.assertEqual(first, (self.folder / "once/slow.nc").read_text(), "taken while it was written")
        self.assertEqual(folders.texts(self.folder / "out"), folders.texts(self.folder / "once"))

    def test_a_program_is_taken_when_it_is_closed(self):
        running = self.start()
        self.exports()
        running.send_signal(signal.SIGTERM)
        self.assertEqual(running.wait(PATIENCE), -signal.SIGTERM)
        said = running.stdout.read()
        self.assertEqual(said.count("out/slow.nc"), 1, said)
        self.assertIn("waiting for programs", running.stderr.read())

    def test_where_the_system_does_not_tell_a_program_is_taken_when_it_rests(self):
        self.start("--poll", "0.3")
        self.exports()

    def test_lines_of_json_come_as_programs_do(self):
        running = self.start("--json", "-")
        self.assertIn('"state":"done"', running.stdout.readline())
        (self.folder / "export/bad.nc").write_text("G0 X0 Y0 Z0 A0 B0 C0\nG1 X1 X2 F100\n")
        self.assertIn('"code":"nc-word-twice"', running.stdout.readline())

    def test_a_folder_that_goes_is_waited_for_and_a_program_that_goes_is_told(self):
        for words in (), ("--poll", "0.3"):
            with self.subTest(words):
                running = self.start(*words)
                (self.folder / "export/b.nc").write_text(folders.program(7))
                self.wait_for(lambda: (self.folder / "out/b.nc").exists())
                (self.folder / "export/b.nc").rename(self.folder / "export/c.nc")
                self.read_until(running, "out/b.nc: warning: the program that it was made of is gone")
                (self.folder / "export").rename(self.folder / "away")
                self.read_until(running, "export: warning: the folder that is watched is gone")
                (self.folder / "export").mkdir()
                shutil.copy(self.folder / "away/plumbline.toml", self.folder / "export")
                (self.folder / "export/d.nc").write_text(folders.program(8))
                self.wait_for(lambda: (self.folder / "out/d.nc").exists())
                running.kill()
                running.wait()
                for name in "out", "export":
                    shutil.rmtree(self.folder / name)
                (self.folder / "away").rename(self.folder / "export")


if __name__ == "__main__":
    unittest.main()
