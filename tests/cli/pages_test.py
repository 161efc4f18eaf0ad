#!/usr/bin/env python3
"""Manual pages and completions hold every option of every command, and are read without complaint by what reads them."""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["PLUMBLINE_PROGRAM"]


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        text = subprocess.run([PROGRAM, "--description"], capture_output=True, text=True, check=True).stdout
        cls.program = json.loads(text)
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        description = cls.folder / "description.json"
        description.write_text(text)
        subprocess.run([sys.executable, ROOT / "cmake/command_pages.py", description, cls.folder], check=True)

    def page(self, name):
        return (self.folder / name).read_text()

    def options(self):
        for command in self.program["commands"]:
            for option in command["options"]:
                yield command["name"], option

    def test_the_description_is_what_the_help_says(self):
        names = [command["name"] for command in self.program["commands"]]
        self.assertIn("compensate", names)
        self.assertGreater(len(list(self.options())), 150)
        for command in self.program["commands"]:
            shown = subprocess.run([PROGRAM, command["name"], "--help"], capture_output=True, text=True, check=True).stdout
            for option in command["options"]:
                self.assertIn(",".join(option["names"]), shown)

    def test_every_option_has_its_place(self):
        bash, zsh, fish = self.page("bash/plumbline"), self.page("zsh/_plumbline"), self.page("fish/plumbline.fish")
        for command, option in self.options():
            manual = self.page(f"man1/plumbline-{command}.1")
            for name in option["names"]:
                with self.subTest(command=command, option=name):
                    self.assertIn(name.replace("-", "\\-"), manual)
                    case = bash[bash.index(f"\n    {command}) options="):].split("\n")[1]
                    self.assertIn(name, case.replace("'", " ").split())
                    arguments = zsh[zsh.index(f"\n    {command})\n"):].split(";;")[0]
                    self.assertIn(f"'*{name}[", arguments)
                    lines = [line for line in fish.split("\n") if f"__fish_seen_subcommand_from {command}'" in line]
                    short = f" -l {name[2:]} " if name.startswith("--") else f" -s {name[1:]} "
                    self.assertTrue(any(short in line + " " for line in lines))

    def test_every_command_has_an_example_that_the_command_line_takes(self):
        for command in self.program["commands"]:
            with self.subTest(command=command["name"]):
                lines = command["footer"].split("\n")
                self.assertEqual(lines[0], "Example:")
                words = lines[1].split()
                self.assertEqual(words[:2], ["plumbline", command["name"]])
                with tempfile.TemporaryDirectory() as folder:  # files are missing there: the work fails, not the reading
                    done = subprocess.run([PROGRAM, *words[1:]], cwd=folder, capture_output=True, text=True)
                self.assertIn(done.returncode, (0, 1), done.stderr)

    def test_the_help_has_groups(self):
        shown = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, check=True).stdout
        for group in {command["group"] for command in self.program["commands"]}:
            self.assertIn(f"\n{group}:\n", shown)

    def test_bash_completes(self):
        script = (f'source "{self.folder}/bash/plumbline"; COMP_WORDS=(plumbline "$@"); COMP_CWORD=$#; _plumbline; '
                  'printf "%s\\n" "${COMPREPLY[@]}"')

        def completed(*words):
            return subprocess.run(["bash", "--norc", "-c", script, "bash", *words], capture_output=True, text=True,
                                  check=True).stdout.split()

        self.assertEqual(completed("comp"), ["compensate", "compare"])
        self.assertEqual(completed("compensate", "--feed-r"), ["--feed-rule"])
        self.assertEqual(completed("compensate", "--feed-rule", ""), ["xyz", "all", "unknown"])
        self.assertEqual(completed("check", "--diagnostics", "j"), ["json"])

    def test_what_reads_them_does_not_complain(self):
        for shell, name in (("bash", "bash/plumbline"), ("zsh", "zsh/_plumbline"), ("fish", "fish/plumbline.fish")):
            if shutil.which(shell):
                done = subprocess.run([shell, "-n", self.folder / name], capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
        if shutil.which("groff"):
            for page in (self.folder / "man1").iterdir():
                done = subprocess.run(["groff", "-man", "-ww", "-z", page], capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stderr), (0, ""), page.name)


if __name__ == "__main__":
    unittest.main()
