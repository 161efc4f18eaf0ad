"""--depfile with make and ninja: what has changed is done again, and nothing else."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import folders

MAIN = "O1\nG90 G21 G94\nG0 X0. Y0. Z0. A0. B0. C0.\nM98 P1000\nM30\n"
SUB = "O1000\nG1 X5. F500.\nM99\n"
TOOLS = 'plumbline = "tools 1"\n[[tool]]\nnumber = 1\nlength_mm = 80\n'

MAKEFILE = """out/%.nc: parts/%.nc
\t{plumbline} compensate -q '$<' -o '$@' --depfile '$@.d'
-include $(shell find out -name '*.d' 2>/dev/null)
"""
NINJA = """rule straighten
  command = {plumbline} compensate -q $in -o $out --depfile $out.d
  depfile = $out.d
  deps = gcc
rule batch
  command = {plumbline} batch -q parts -o all --json $out --depfile $out.d
  depfile = $out.d
  deps = gcc
build out/a.nc: straighten parts/a.nc
build all.jsonl: batch
default out/a.nc
"""


class BuildTools(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name) / "a shop #1"  # names that build tools stumble over
        parts = self.folder / "parts"
        parts.mkdir(parents=True)
        (self.folder / "out").mkdir()
        (self.folder / "tables").mkdir()
        (parts / "a.nc").write_text(MAIN)
        (parts / "O1000.nc").write_text(SUB)
        (self.folder / "tables/the tools.toml").write_text(TOOLS)
        shutil.copy(folders.MODEL, self.folder / "tables/model.toml")
        (parts / "plumbline.toml").write_text(
            'plumbline = "settings 1"\nmodel = "../tables/model.toml"\ntools = "../tables/the tools.toml"\n'
            'dialect = "fanuc"\n[work_offset]\nG54 = [0, 0, -1008, 0, 0, 0]\n')
        (self.folder / "Makefile").write_text(MAKEFILE.format(plumbline=folders.PLUMBLINE))
        (self.folder / "build.ninja").write_text(NINJA.format(plumbline=folders.PLUMBLINE))

    def run_tool(self, *words):
        done = subprocess.run(words, cwd=self.folder, env=folders.ENVIRONMENT, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def check(self, target, is_idle, *words):
        output = self.folder / target
        self.run_tool(*words)
        for changed in ("parts/a.nc", "parts/O1000.nc", "parts/plumbline.toml", "tables/model.toml",
                        "tables/the tools.toml"):
            self.assertTrue(is_idle(self.run_tool(*words)), f"{words} has nothing to do")
            before = output.stat().st_mtime_ns
            time.sleep(0.02)
            path = self.folder / changed
            path.write_text(path.read_text() + "\n")
            self.run_tool(*words)
            self.assertNotEqual(output.stat().st_mtime_ns, before, f"{target} depends on {changed}")

    def test_make(self):
        if shutil.which("make") is None:
            return print("this test is skipped: make is not installed")
        self.check("out/a.nc", lambda said: "up to date" in said, "make", "out/a.nc")
        # A subprogram that is gone is the program's to be refused for, not make's.
        (self.folder / "parts/O1000.nc").unlink()
        done = subprocess.run(["make", "out/a.nc"], cwd=self.folder, env=folders.ENVIRONMENT, capture_output=True,
                              text=True)
        self.assertNotIn("No rule to make target", done.stderr)
        self.assertIn("nc-", done.stderr)

    def test_ninja(self):
        if shutil.which("ninja") is None:
            return print("this test is skipped: ninja is not installed")
        self.check("out/a.nc", lambda said: "no work to do" in said, "ninja")

    def test_ninja_with_a_folder(self):
        if shutil.which("ninja") is None:
            return print("this test is skipped: ninja is not installed")
        self.check("all.jsonl", lambda said: "no work to do" in said, "ninja", "all.jsonl")
        self.assertFalse((self.folder / "all/b.nc").exists())
        time.sleep(0.02)
        (self.folder / "parts/b.nc").write_text(MAIN.replace("O1\n", "O2\n"))
        self.run_tool("ninja", "all.jsonl")
        self.assertTrue((self.folder / "all/b.nc").exists(), "the folder is a dependency, too")


if __name__ == "__main__":
    unittest.main()
