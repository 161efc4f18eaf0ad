"""scripts/spoil: each way of spoiling changes what it says, and players in place of the programs are scored rightly."""

import importlib.machinery
import importlib.util
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "spoil"
LOADER = importlib.machinery.SourceFileLoader("spoil", str(SCRIPT))
spoil = importlib.util.module_from_spec(importlib.util.spec_from_loader("spoil", LOADER))
LOADER.exec_module(spoil)

# Writes a dataset of four runs as plumbline_draw_case does.
DRAW = """#!/usr/bin/env python3
import pathlib, sys
data = pathlib.Path(sys.argv[sys.argv.index("-o") + 1]) / "data"
data.mkdir(parents=True)
(data.parent / "base.toml").touch()
text = 'plumbline = "dataset 1"\\nmachine = "m"\\n'
for r, (centre, tilt, payload) in enumerate([([0, 100, -1008], [-22, 0, 0], 0), ([70, -70, -1008], [15, -12, 0], 0),
                                             ([0, 60, -950], [0, 20, 0], 20), ([0, 100, -1008], [0, 0, 0], 0)]):
    text += f'''
[[run]]
id = "{r}"
file = "{r}.csv"
centre_mm = {centre}
radius_mm = 144
bar_mm = 150
tilt_deg = {tilt}
direction = "ccw"
feed_mm_min = 1000
start_s = {60 + 100 * r}
payload_kg = {payload}
'''
    rows = "time_s,angle_deg,radial_um," + ",".join(f"torque{j}_Nm" for j in range(1, 7)) + "\\n"
    for i in range(60):
        rows += f"{i * 0.9:.3f},{6 * i:.3f},{(i * 7 + r) % 13:.1f}," + ",".join(f"{(i + j * r) % 9 + j - 3:.2f}" for j in range(6)) + "\\n"
    (data / f"{r}.csv").write_text(rows)
(data / "dataset.toml").write_text(text)
"""

# Says of the runs in $SAY (id:kind, ...) that they are spoiled.
PLUMBLINE = """#!/usr/bin/env python3
import json, os, pathlib, sys
words = dict(zip(sys.argv[2::2], sys.argv[3::2]))
if sys.argv[1] == "diagnose":
    out = pathlib.Path(words["-o"])
    out.mkdir()
    (out / "diagnosis.json").write_text(json.dumps({"verdict": os.environ.get("VERDICT", "unknown")}))
    sys.exit()
faults = [{"kind": kind, "runs": [run], "all": run == "all", "or": [], "blocks": True, "text": "spoiled"}
          for run, kind in (pair.split(":") for pair in os.environ.get("SAY", "").split(",") if pair)]
pathlib.Path(words["--json"]).write_text(json.dumps({"faults": faults}))
sys.exit(3 if faults else 0)
"""


class Spoil(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.players = {}
        for name, text in (("draw", DRAW), ("plumbline", PLUMBLINE)):
            self.players[name] = pathlib.Path(self.folder.name) / name
            self.players[name].write_text(text)
            self.players[name].chmod(0o755)

    def tearDown(self):
        self.folder.cleanup()

    def run_script(self, *arguments, say="", verdict="unknown"):
        return subprocess.run([sys.executable, "-B", SCRIPT, "--draw", self.players["draw"], "--plumbline",
                               self.players["plumbline"], "--jobs", "1", *arguments], capture_output=True, text=True,
                              env={**os.environ, "SAY": say, "VERDICT": verdict})

    def drawn(self):
        folder = pathlib.Path(self.folder.name) / f"case-{random.random()}"
        subprocess.run([self.players["draw"], "-o", folder], check=True)
        return folder / "data"

    def test_each_kind_changes_the_data_of_the_guilty_alone(self):
        for kind in spoil.KINDS:
            with self.subTest(kind.__name__):
                data = self.drawn()
                clean, spoiled = spoil.Data(data), spoil.Data(data)
                guilty, kinds = kind(spoiled, random.Random(kind.__name__))
                self.assertTrue(kinds)
                changed = [a["id"] for a, b in zip(clean.runs, spoiled.runs) if a != b]
                self.assertEqual(sorted(changed), sorted(guilty) if guilty is not None else [r["id"] for r in clean.runs])
                out = data.parent / "spoiled"
                spoiled.write(out)
                self.assertTrue((out / "dataset.toml").exists())

    def test_counts_runs_and_kinds(self):
        done = self.run_script("--seeds", "1:3", "--kinds", "motor_sign_all", say="all:motor-sign")
        self.assertIn("guilty run and kind named: 2 of 2", done.stdout, done.stderr)
        done = self.run_script("--seeds", "1:2", "--kinds", "motor_sign_all", "--require", "1", say="all:bar-sign")
        self.assertIn("named: 0 of 1", done.stdout)
        self.assertEqual(done.returncode, 1)

    def test_counts_wrong_names_and_false_alarms(self):
        done = self.run_script("--seeds", "1:2", "--kinds", "motor_sign_all", "--diagnose", say="all:motor-sign", verdict="named")
        self.assertIn("a wrong name from diagnose: 1 of 1", done.stdout)
        self.assertIn("said to be spoiled: 0 of 2", self.run_script("--seeds", "1:3", "--clean").stdout)
        self.assertIn("said to be spoiled: 2 of 2", self.run_script("--seeds", "1:3", "--clean", say="1:tilt").stdout)


if __name__ == "__main__":
    unittest.main()
