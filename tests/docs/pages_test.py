"""The pages for users, tried as a user would: in a folder with the files that a page speaks of, its commands are run as they
stand there, from the first to the last. Files that it shows whole are written from it."""
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLUMBLINE = os.environ["PLUMBLINE_PROGRAM"]
PROGRAMS = {"plumbline", "find", "make", "ninja", "python3", "linuxcnc"}
PATIENCE = 120
PART = """G21 G90 G94
G0 X0 Y0 Z5 A0 B0 C0
G1 Z0 F500
G1 X20.5 Y10.25 A5 B-2.5 C1
G2 X30.5 Y20.25 I5 J5
M2
"""
SETTINGS = 'plumbline = "settings 1"\nmodel = "{model}"\n[work_offset]\nG54 = [0, 0, -1008, 0, 0, 0]\n'


def commands(text):
    """The lines that are set in and begin with a program; what goes on in the next line, with it."""
    text = re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)
    lines = re.findall(r"^ {4}(\S(?:.*\\\n.*)*.*)$", text, re.MULTILINE)
    return [line for line in lines if line.split()[0] in PROGRAMS]


def fenced(text, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


class Pages(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        tools = self.folder / "programs of the system"
        tools.mkdir()
        (tools / "plumbline").symlink_to(PLUMBLINE)
        self.environment = {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}", "XDG_CONFIG_HOME": "/nonexistent"}
        self.environment.pop("PLUMBLINE_SETTINGS", None)
        self.model = shutil.copy(ROOT / "models/pm600-like.toml", self.folder / "machine.toml")
        (self.folder / "part.ngc").write_text(PART)

    def page(self, name):
        return (ROOT / "docs" / f"{name}.md").read_text()

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def run_shell(self, command, code=0):
        done = subprocess.run(["bash", "-c", command], cwd=self.folder, env=self.environment, capture_output=True,
                              text=True, timeout=PATIENCE, stdin=subprocess.DEVNULL)
        self.assertEqual(done.returncode, code, f"{command}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def run_page(self, name, codes=(), instead=()):
        """Runs all commands of a page. codes: exit codes other than 0, by a part of the command; instead: what is done in
        place of a command, by a part of it."""
        codes, instead = dict(codes), dict(instead)
        found = commands(self.page(name))
        self.assertGreater(len(found), 1, name)
        used = set()
        for command in found:
            known = [part for part in (*codes, *instead) if part in command]
            used.update(known)
            other = [instead[part] for part in known if part in instead]
            if other:
                other[0](command)
            else:
                self.run_shell(command, codes[known[0]] if known else 0)
        self.assertEqual(used, {*codes, *instead}, "all of them stand on the page")

    def test_using(self):
        page = self.page("using")
        settings = next(block for block in fenced(page, "toml") if "[machines.hex-3]" in block)
        self.write("plumbline.toml", settings)
        self.write("tools-hex-3.toml", re.sub(r"(?m)^  ", "", fenced(re.sub(r"(?m)^  ", "", page), "toml")[1]))
        for name in ("hex-3", "hex-4"):
            self.write(f"models/{name}.toml", pathlib.Path(self.model).read_text())
        self.run_page("using", instead={"--tolerance 0.5um": lambda command: self.run_shell(command + " --no-settings")})
        self.assertIn("machine hex-3", (self.folder / "part_hex-3.ngc").read_text())
        said = self.run_shell("plumbline settings part.ngc")
        self.assertIn("hex-3", said)
        self.assertIn("tolerance 0.5 um", (self.folder / "part-c.ngc").read_text())

    def test_posts(self):
        self.run_page("posts")
        self.assertIn("compensated this program", (self.folder / "part-c.ngc").read_text())
        python = os.environ.get("PLUMBLINE_PYTHON")
        if not python:
            return
        lines = f"program = open('part.ngc').read()\n{fenced(self.page('posts'), 'python')[0]}\nprint(program, end='')\n"
        self.write("post.py", lines)
        self.environment["PYTHONPATH"] = python
        self.assertEqual(self.run_shell("/usr/bin/python3 post.py"), (self.folder / "part-c.ngc").read_text())

    def test_measuring(self):
        shutil.copytree(ROOT / "tests/blind/open-01/data", self.folder / "measured")
        shutil.copy(ROOT / "examples/07_a_model_of_your_machine/bench.ini", self.folder / "hexapod.ini")
        shutil.copy(ROOT / "examples/07_a_model_of_your_machine/joints.hal", self.folder / "joints.hal")

        def on(model):
            """Runs a command on another machine than the one before it."""
            def run(command):
                shutil.copy(ROOT / model, self.folder / "machine.toml")
                self.run_shell(command)
            return run

        def learnt(command):
            self.assertIn("backlash", self.run_shell(command))
        self.run_page("measuring", instead={"map -m": on("models/pm600-like.toml"), "diagnose -m": learnt,
                                            "compare -m": on("tests/blind/open-01/base.toml")})

    def test_folders(self):
        for name in ("a.nc", "rough-1.nc", "inner/rough-2.nc"):
            self.write(f"parts/{name}", PART)
            self.write(f"export/{name}", PART)
        settings = SETTINGS.format(model="../machine.toml")
        self.write("export/plumbline.toml", settings)

        def one_word(command):
            self.write("parts/plumbline.toml", settings)
            self.assertIn("3 compensated", self.run_shell(command))

        def in_lines(command):
            self.assertIn("3 unchanged", self.run_shell(command))
            self.assertEqual(len((self.folder / "out/batch.jsonl").read_text().splitlines()), 4)

        def watch(command):
            running = subprocess.Popen(["bash", "-c", "exec " + command.replace("/nc/straight", "straight")],
                                       cwd=self.folder, env=self.environment, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            end = time.monotonic() + PATIENCE
            while not (self.folder / "straight/inner/rough-2.nc").exists():
                self.assertLess(time.monotonic(), end)
                time.sleep(0.05)
            running.send_signal(signal.SIGTERM)
            self.assertEqual(running.wait(PATIENCE), -signal.SIGTERM)

        self.run_page("folders", instead={"--watch": watch, "--json out": in_lines, "batch parts -o out": one_word})
        page = self.page("folders")
        self.write("Makefile", fenced(page, "make")[0])
        self.write("build.ninja", fenced(page, "ninja")[0])
        for tool, target in (("make", "out/a.nc"), ("ninja", "all.jsonl")):
            if shutil.which(tool) is None:
                print(f"this test is skipped: {tool} is not installed")
                continue
            shutil.rmtree(self.folder / "out", ignore_errors=True)
            self.run_shell(f"{tool} {target}")
            self.assertTrue((self.folder / target).exists())

        self.programs_of_two_controls_lie_in_two_folders()

    def programs_of_two_controls_lie_in_two_folders(self):
        of_the_control = 'plumbline = "settings 1"\n{option}\n[work_offset]\n{system} = [0, 0, -1008, 0, 0, 0]\n'
        of_the_machine = 'plumbline = "settings 1"\nmodel = "../machine.toml"\n'
        self.write("shop/plumbline.toml", of_the_machine)
        self.write("shop/linuxcnc/a.ngc", "G54\n" + PART)
        self.write("shop/linuxcnc/plumbline.toml", of_the_control.format(option="", system="G54"))
        self.write("shop/okuma/a.min", "G15 H1\n" + PART)
        self.write("shop/okuma/plumbline.toml", of_the_control.format(option='feed_rule = "xyz"', system="G15H1"))
        self.assertIn("2 compensated", self.run_shell("plumbline batch shop -o straight-shop"))
        self.write("shop/plumbline.toml", of_the_machine + "[work_offset]\nG55 = [0, 0, -1008, 0, 0, 0]\n")
        self.assertIn("G55, which okuma does not have", self.run_shell("plumbline batch shop -o straight-shop", 1))

    def test_linuxcnc(self):
        (self.folder / "models").mkdir()
        shutil.copy(self.model, self.folder / "models/pm600-like.toml")

        def filter_line(_):
            """What the screen does when the program is opened."""
            page = self.page("linuxcnc")
            folder = self.folder / "hexapod"
            self.write("hexapod/part.nc", PART)
            settings = fenced(page, "toml")[0]
            settings = settings.replace("/home/cnc/hexapod/machine.toml", str(self.model))
            settings = settings.replace("/home/cnc/linuxcnc/configs/hexapod", str(folder))
            tools = re.search(r'tools = "(.*)"', settings)[1]
            self.write("hexapod/plumbline.toml", settings.replace(tools, str(next(folder.glob("*.tbl")))))
            command = re.search(r"^nc = (.*)$", fenced(page, "ini")[0], re.MULTILINE)[1]
            said = self.run_shell(f"cd hexapod && {command} 'part.nc'")
            self.assertIn("compensated this program", said)
        self.run_page("linuxcnc", instead={"linuxcnc hexapod/hexapod.ini": filter_line})


if __name__ == "__main__":
    unittest.main()
