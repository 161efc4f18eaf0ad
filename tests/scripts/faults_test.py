"""scripts/faults, short: plumbline as it was built leaves nothing half done, and a program that does is found out."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "faults"
PROGRAM = os.environ["PLUMBLINE_PROGRAM"]

# Runs plumbline, and does something wrong with its output before or after.
PLAYER = """#!/bin/sh
case "$*" in *"-o out/part.ngc"*) {before} ;; esac
'{program}' "$@"
code=$?
case "$*" in *"-o out/part.ngc"*) {after} ;; esac
exit $code
"""


def faults(program, *options):
    return subprocess.run([sys.executable, "-B", SCRIPT, "--program", program, "--tasks", "pair,compensate,trace,simulate",
                           *options], capture_output=True, text=True)


class Faults(unittest.TestCase):
    def player(self, before=":", after=":"):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name) / "plumbline"
        path.write_text(PLAYER.format(program=PROGRAM, before=before, after=after))
        path.chmod(0o755)
        return path

    def test_nothing_is_half_done(self):
        done = faults(PROGRAM, "--faults", "40", "--kills", "20", "--writers", "4")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("40 faults: 0 broken", done.stdout)
        self.assertIn("20 kills: 0 broken", done.stdout)
        self.assertIn("4 pairs of writers: 0 broken", done.stdout)

    def test_a_temporary_file_is_found(self):
        left = "[ $code = 0 ] || touch out/.plumbline-0123456789abcdef.tmp"
        done = faults(self.player(after=left), "--faults", "20", "--kills", "0", "--writers", "0", "--tasks", "pair")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("left behind", done.stdout)

    def test_half_a_file_is_found(self):
        done = faults(self.player(after="[ $code = 0 ] || echo half >out/part.ngc"), "--faults", "20", "--kills", "0",
                      "--writers", "0", "--tasks", "pair")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("half written", done.stdout)

    def test_a_mixed_pair_of_writers_is_found(self):
        first = "mkdir busy 2>/dev/null && first=yes"
        mix = ("if [ $first ]; then touch over; sleep 1; rm over; rmdir busy; else "
               "while [ -d busy ] && [ ! -e over ]; do sleep 0.05; done; echo mixed >>out/part.json; fi")
        done = faults(self.player(first, mix), "--faults", "0", "--kills", "0", "--writers", "3", "--tasks", "pair")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("not of one run", done.stdout)

    def test_tasks_that_there_are_not_are_refused(self):
        done = subprocess.run([sys.executable, "-B", SCRIPT, "--tasks", "pair,nothing"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--tasks are some of", done.stderr)


if __name__ == "__main__":
    unittest.main()
