"""scripts/setup on systems with and without dpkg, packages, root: dpkg-query and apt-get are played by small scripts."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ("bash", "cat", "dirname", "env", "rm", "sed")
NOBODY = 65534

# The package is installed if a file of its name is in $STATE.
DPKG_QUERY = """#!/bin/bash
if [[ -e $STATE/${@: -1} ]]; then printf installed; else exit 1; fi
"""
# Logs what it is asked; knows packages only after `update` where $STATE/.no-lists is; installs for good.
APT_GET = """#!/bin/bash
echo "$*" >> "$STATE/.log"
for word in "$@"; do
  case $word in
    update) rm -f "$STATE/.no-lists"; exit 0 ;;
    -s) simulate=yes ;;
  esac
done
[[ -e $STATE/.no-lists ]] && exit 100
[[ ${simulate:-} ]] && exit 0
[[ $DEBIAN_FRONTEND == noninteractive ]] || exit 101
seen=
for word in "$@"; do
  if [[ $seen && $word != -* ]]; then : > "$STATE/$word"; fi
  [[ $word == install ]] && seen=yes
done
exit 0
"""


def packages(*lists):
    return [line for name in lists for line in (ROOT / name).read_text().split("\n") if line]


class Setup(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        base = pathlib.Path(self.folder.name)
        self.bin, self.state = base / "bin", base / "state"
        project = base / "project"
        for path in (self.bin, self.state, project / "scripts"):
            path.mkdir(parents=True)
        for name in ("scripts/setup", "packages.txt", "packages-dev.txt"):
            shutil.copy(ROOT / name, project / name)
        for tool in TOOLS:
            (self.bin / tool).symlink_to(shutil.which(tool))
        self.script = project / "scripts" / "setup"
        for path in (base, *base.rglob("*")):
            if not path.is_symlink():
                path.chmod(0o777)

    def play(self, name, text):
        (self.bin / name).write_text(text)
        (self.bin / name).chmod(0o755)

    def play_debian(self, installed=(), lists=True):
        self.play("dpkg-query", DPKG_QUERY)
        self.play("apt-get", APT_GET)
        for package in installed:
            (self.state / package).touch()
        if not lists:
            (self.state / ".no-lists").touch()

    def run_setup(self, *arguments, as_nobody=False):
        environment = {"PATH": str(self.bin), "STATE": str(self.state)}
        identity = {"user": NOBODY, "group": NOBODY, "extra_groups": []} if as_nobody and os.geteuid() == 0 else {}
        return subprocess.run([self.script, *arguments], env=environment, stdin=subprocess.DEVNULL, text=True,
                              capture_output=True, **identity)

    def log(self):
        path = self.state / ".log"
        return path.read_text().splitlines() if path.exists() else []

    def need_root(self):
        if os.geteuid() != 0:
            reason = "needs root: installs, as far as the script can tell"
            print(f"\nthis part is skipped: {reason}")
            self.skipTest(reason)

    def test_lists_are_sorted_and_name_packages(self):
        for name in ("packages.txt", "packages-dev.txt"):
            lines = (ROOT / name).read_text().splitlines()
            self.assertEqual(lines, sorted(set(lines)), name)
            for line in lines:
                self.assertTrue(re.fullmatch(r"[a-z0-9][a-z0-9+.-]+", line), line)

    def test_does_nothing_where_all_is_installed(self):
        self.play_debian(installed=packages("packages.txt"))
        run = self.run_setup()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.log(), [])

    def test_installs_what_is_missing_and_no_more(self):
        self.need_root()
        self.play_debian(installed=packages("packages.txt"))
        run = self.run_setup("--dev")
        self.assertEqual(run.returncode, 0, run.stderr)
        install = self.log()[-1]
        self.assertIn("--no-install-recommends " + " ".join(packages("packages-dev.txt")), install)
        self.assertNotIn(packages("packages.txt")[0], install)
        self.assertFalse([line for line in self.log() if line.endswith(" update")])

    def test_fetches_the_lists_where_there_are_none(self):
        self.need_root()
        self.play_debian(lists=False)
        run = self.run_setup("--with-oracle")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(len([line for line in self.log() if line.endswith(" update")]), 1)
        self.assertTrue((self.state / "linuxcnc-uspace").exists())

    def test_installs_the_fuzzer_when_asked(self):
        self.need_root()
        self.play_debian(installed=packages("packages.txt"))
        run = self.run_setup("--with-fuzzer")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("--no-install-recommends clang libclang-rt-14-dev", self.log()[-1])

    def test_makes_what_debian_has_not_for_windows(self):
        self.need_root()
        self.play_debian(installed=packages("packages.txt"))
        script = self.script.parent / "windows_sqlite"
        script.write_text("#!/bin/bash\n[[ -e $STATE/wine64 ]] && : > \"$STATE/.sqlite\"\n")
        script.chmod(0o755)
        self.assertEqual(self.run_setup().returncode, 0)
        self.assertFalse((self.state / ".sqlite").exists())
        run = self.run_setup("--with-windows")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("g++-mingw-w64-x86-64-posix", self.log()[-1])
        self.assertTrue((self.state / ".sqlite").exists())
        script.write_text("#!/bin/bash\nexit 1\n")
        self.assertNotEqual(self.run_setup("--with-windows").returncode, 0)

    def test_without_root_says_what_to_run(self):
        self.play_debian(installed=packages("packages.txt")[1:])
        run = self.run_setup(as_nobody=True)
        self.assertEqual(run.returncode, 1)
        self.assertEqual(run.stderr.splitlines()[-1], "apt-get update && apt-get install -y --no-install-recommends "
                         + packages("packages.txt")[0])

    def test_without_dpkg_says_what_is_needed(self):
        run = self.run_setup()
        self.assertEqual(run.returncode, 1)
        self.assertIn(" ".join(packages("packages.txt")), run.stderr)

    def test_unknown_option_is_wrong_usage(self):
        self.assertEqual(self.run_setup("--everything").returncode, 2)


if __name__ == "__main__":
    unittest.main()
