"""scripts/blind with players in place of the programs: one draws answers, one diagnoses, right or wrong as told."""

import importlib.machinery
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "blind"
LOADER = importlib.machinery.SourceFileLoader("blind", str(SCRIPT))
blind = importlib.util.module_from_spec(importlib.util.spec_from_loader("blind", LOADER))
LOADER.exec_module(blind)

# Writes what plumbline_draw_case writes, but for the measurements.
DRAW = """#!/usr/bin/env python3
import json, pathlib, sys
words = dict(zip(sys.argv[1::2], sys.argv[2::2]))
out = pathlib.Path(words["-o"])
for folder in ("data", "holdout"):
    (out / folder).mkdir(parents=True)
    (out / folder / "dataset.toml").touch()
(out / "base.toml").touch()
name = words["--effect"]
outside = name.startswith("outside:")
hidden = [] if name == "none" else [{"name": name.replace("outside:", "unknown:"), "snr": float(words["--snr"]),
                                     "outside": 40 if outside else 0, "beyond_others": 40,
                                     "parameters": {"mass_kg": 3}}]
verdict = "nothing-missing" if not hidden else "unknown" if outside else "named"
(out / "answer.json").write_text(json.dumps({"verdict": verdict, "effects": hidden}))
"""

# Diagnoses by looking at the answer; says $SAY instead where that is set.
PLUMBLINE = """#!/usr/bin/env python3
import json, os, pathlib, sys
words = dict(zip(sys.argv[2::2], sys.argv[3::2]))
if sys.argv[1] == "compare":
    after = "found" in words["-m"]
    pathlib.Path(words["--json"]).write_text(json.dumps({"radial_rms_um": 0.55 if after else 3, "torque_rms_Nm": 0.05}))
    sys.exit()
model = pathlib.Path(words["-m"])
if os.environ.get("SAY") == "crash":
    sys.exit("lost its way")
own = model.parent / "answer.json"
kept = model.parent.parent / "answers" / f"{model.parent.name}.json"
answer = json.loads((own if own.exists() else kept).read_text())
names = [os.environ["SAY"]] if os.environ.get("SAY") else [e["name"] for e in answer["effects"]]
known = [n for n in names if not n.startswith("unknown") and n not in words.get("--without", "").split(",")]
out = pathlib.Path(words["-o"])
out.mkdir()
effects = [{"name": n, "alternatives": [], "parameters": {"mass_kg": 3.1}, "standard_errors": {"mass_kg": 0.1}}
           for n in known]
verdict = "named" if known else "unknown" if names else "nothing-missing"
(out / "diagnosis.json").write_text(json.dumps({"verdict": verdict, "effects": effects, "confidence_set": known}))
"""


class Blind(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.programs = {}
        for name, text in (("draw", DRAW), ("plumbline", PLUMBLINE)):
            path = pathlib.Path(self.folder.name) / name
            path.write_text(text)
            path.chmod(0o755)
            self.programs[name] = path

    def run_blind(self, *arguments, say=""):
        command = [sys.executable, "-B", SCRIPT, "--plumbline", self.programs["plumbline"], "--draw",
                   self.programs["draw"], "--jobs", "2", *arguments]
        run = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "SAY": say})
        return run.returncode, run.stdout

    def test_all_right(self):
        status, text = self.run_blind("--seeds", "1:3", "--effect", "payload,level", "--require", "1")
        self.assertEqual(status, 0, text)
        self.assertIn("right:    2 of    2  100.0 %", text)
        self.assertIn("parameters inside their 95 % intervals         2 of    2  100.0 %", text)
        self.assertIn("held-out radial rms within 1.25 of the noise    2 of    2  100.0 %", text)
        self.assertNotIn("mistaken for", text)

    def test_all_wrong(self):
        status, text = self.run_blind("--seeds", "1:3", "--effect", "payload", "--require", "0.5", say="cable")
        self.assertEqual(status, 1)
        self.assertIn("   2  payload -> cable", text)
        self.assertIn("miss every hidden one    2 of    2", text)

    def test_false_alarms(self):
        self.assertIn("false alarms     0 of    2", self.run_blind("--seeds", "1:3", "--effect", "none")[1])
        self.assertIn("false alarms     2 of    2", self.run_blind("--seeds", "1:3", "--effect", "none", say="level")[1])

    def test_unknown(self):
        text = self.run_blind("--seeds", "1:3", "--effect", "outside")[1]
        self.assertIn("said so    2 of    2", text)
        text = self.run_blind("--seeds", "1:3", "--effect", "outside", say="level")[1]
        self.assertIn("said so    0 of    2", text)

    def test_left_out_is_unknown(self):
        self.assertIn("said so    2 of    2", self.run_blind("--seeds", "1:3", "--effect", "level", "--leave-out")[1])

    def test_a_crash_is_counted_and_shown(self):
        status, text = self.run_blind("--seeds", "1:3", say="crash")
        self.assertEqual(status, 1)
        self.assertIn("2 failed", text)
        self.assertIn("lost its way", text)

    def test_kept_cases(self):
        status, text = self.run_blind("--cases", str(SCRIPT.parents[1] / "tests" / "blind"))
        self.assertEqual(status, 0, text)
        self.assertIn("right:    6 of    6", text)

    def test_what_is_not_built(self):
        self.programs["draw"] = pathlib.Path(self.folder.name) / "none"
        self.assertEqual(self.run_blind()[0], 2)


class Cases(unittest.TestCase):
    def test_each_effect_meets_each_machine_and_seeds_decide(self):
        options = blind.parse(["--seeds", "1:121"])
        cases = blind.plan_cases(options)
        self.assertEqual(len({(c.machine, c.effect) for c in cases}), 120)
        self.assertEqual(cases, blind.plan_cases(options))
        self.assertTrue(all(12 <= c.snr <= 300 for c in cases))

    def test_classes_and_alternatives(self):
        result = {"answer": {"effects": [{"name": "platform-mass", "snr": 20}]},
                  "found": {"verdict": "named", "effects": [{"name": "counterbalance"}], "confidence_set": ["cable"]}}
        self.assertTrue(blind.right_names(result))
        self.assertFalse(blind.in_set(result))
        result["found"]["effects"] = [{"name": "cable", "alternatives": ["platform-mass"]}]
        self.assertTrue(blind.right_names(result))
        result["found"]["effects"].append({"name": "level"})
        self.assertFalse(blind.right_names(result))

    def test_intervals(self):
        result = {"answer": {"effects": [{"name": "backlash", "parameters": {"width_um": [1, 2, 0]}}]},
                  "found": {"effects": [{"name": "backlash", "parameters": {"width_um": [1.1, 3, 0]},
                                         "standard_errors": {"width_um": [0.1, 0.1, 0]}}]}}
        self.assertEqual([inside for *_, inside in blind.intervals(result)], [True, False])
        result["answer"]["effects"][0]["departure"] = {"width_um": [2, 3, 0.5]}
        self.assertEqual([inside for *_, inside in blind.intervals(result)], [True, False])
        self.assertEqual([inside for *_, inside in blind.intervals(result, "departure")], [False, True, False])

    def test_an_amplitude_has_no_sign_of_its_own(self):
        result = {"answer": {"effects": [{"name": "cyclic", "parameters": {"amplitude_um": [-1], "phase_deg": [30]}}]},
                  "found": {"effects": [{"name": "cyclic", "parameters": {"amplitude_um": [1.1], "phase_deg": [-150]},
                                         "standard_errors": {"amplitude_um": [0.1], "phase_deg": [5]}}]}}
        self.assertEqual(blind.intervals(result), [("cyclic", "amplitude_um", True)])

    def test_bands(self):
        self.assertEqual([blind.band_name(blind.band_of(s)) for s in (11, 12, 500)],
                         ["10 to 12", "12 to 20", "over 150"])


if __name__ == "__main__":
    unittest.main()
