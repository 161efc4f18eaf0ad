"""`plumbline batch`, killed at any moment and run again, and two of them at a time."""
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import folders

PROGRAMS = 400
KILLS = 50
SEED = 21


class Kills(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.names = folders.make(self.folder / "parts", PROGRAMS)

    def start(self, out):
        return subprocess.Popen([folders.PLUMBLINE, "batch", "parts", "-o", out, "--json", f"{out}.jsonl"],
                                cwd=self.folder, env=folders.ENVIRONMENT, stdout=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)

    def whole(self, out):
        """Outputs with the numbers of their files: one that is made anew has another."""
        return {path.relative_to(self.folder / out): (path.stat().st_ino, path.stat().st_mtime_ns)
                for path in (self.folder / out).rglob("*.nc")}

    def test_killed_fifty_times_it_makes_the_same_files_and_none_twice(self):
        begin = time.monotonic()
        done = folders.batch("parts", "-o", "once", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        took = time.monotonic() - begin
        expected = folders.texts(self.folder / "once")
        self.assertEqual(sorted(expected), sorted(self.names))

        random.seed(SEED)
        before, kills, in_the_middle = {}, 0, 0
        while kills < KILLS:
            running = self.start("out")
            time.sleep(random.uniform(0, 0.8 * took))
            running.kill()
            kills += 1
            self.assertEqual(running.wait() in (0, -9), True)
            after = self.whole("out")
            for name, numbers in before.items():
                self.assertEqual(after.get(name), numbers, f"{name} was whole, and was made again")
            for name in after:
                self.assertEqual((self.folder / "out" / name).read_bytes(), expected[str(name)], f"{name} is not whole")
            in_the_middle += 0 < len(after) < PROGRAMS
            before = after
            if len(after) == PROGRAMS:  # all are there: from the begin again
                subprocess.run(["rm", "-r", self.folder / "out"], check=True)
                before = {}
        self.assertGreater(in_the_middle, 2, "the kills came too early or too late to show anything")

        last = folders.batch("parts", "-o", "out", "--json", "out.jsonl", cwd=self.folder)
        self.assertEqual(last.returncode, 0, last.stderr)
        after = self.whole("out")
        for name, numbers in before.items():
            self.assertEqual(after[name], numbers)
        self.assertEqual(folders.texts(self.folder / "out"), expected)
        lines = [json.loads(line) for line in (self.folder / "out.jsonl").read_text().splitlines()]
        self.assertEqual([line["state"] for line in lines[:-1]].count("unchanged"), len(before))
        left = [path for path in (self.folder / "out").rglob(".*") if path.name.endswith(".tmp")]
        self.assertLessEqual(len(left), 0, left)

    def test_two_at_a_time_make_the_same_files(self):
        expected = folders.batch("parts", "-o", "once", cwd=self.folder)
        self.assertEqual(expected.returncode, 0, expected.stderr)
        running = [self.start("out"), self.start("out")]
        self.assertEqual([one.wait() for one in running], [0, 0])
        self.assertEqual(folders.texts(self.folder / "out"), folders.texts(self.folder / "once"))
        again = folders.batch("parts", "-o", "out", cwd=self.folder)
        self.assertIn(f"{PROGRAMS} unchanged", again.stderr)


if __name__ == "__main__":
    unittest.main()
