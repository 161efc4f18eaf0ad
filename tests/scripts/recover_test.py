"""scripts/recover with players in place of the programs: values off by known numbers of standard errors."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "recover"

DRAW = """#!/usr/bin/env python3
import json, pathlib, sys
out = pathlib.Path(dict(zip(sys.argv[1::2], sys.argv[2::2]))["-o"])
(out / "answer.json").write_text(json.dumps({"machine_is": {
    "compliance_per_length_um_N_m": [0.01] * 6, "compliance_um_N": [0.008] * 6, "gravity_m_s2": [-0.02, 0.01, -10],
    "base_um": [[1, 2, 3]] * 6, "strut_offset_um": [5] * 6}}))
"""

# K1 one standard error too large, K2 three too small, the second level angle exact, a base joint half an error off.
IDENTIFY = """#!/usr/bin/env python3
import json, pathlib, sys
def row(label, effect, key, value, error, index=0):
    return {"label": label, "effect": effect, "key": key, "value": value, "standard_error": error, "index": index}
rows = [row("K1", "axial-elasticity", "compliance_per_length_um_N_m", 0.011, 0.001),
        row("K2", "axial-elasticity", "compliance_um_N", 0.005, 0.001),
        row("tilt", "level", "tilt_mrad", 2.0, 0.1, 1), row("base", "joint-position", "base_um", 2.5, 1, 4),
        row("offset", "strut-offset", "length_um", 5, 0)]
ones = [[1.0 if i == j else 0.0 for i in range(5)] for j in range(5)]
words = dict(zip(sys.argv[2::2], sys.argv[3::2]))
pathlib.Path(words["--json"]).write_text(json.dumps({"stages": [{"unknowns": rows, "correlations": ones}]}))
"""


class Recover(unittest.TestCase):
    def test_counts_what_lies_inside(self):
        with tempfile.TemporaryDirectory() as folder:
            players = {}
            for name, text in (("draw", DRAW), ("identify", IDENTIFY)):
                players[name] = pathlib.Path(folder) / name
                players[name].write_text(text)
                players[name].chmod(0o755)
            run = subprocess.run([sys.executable, "-B", SCRIPT, "--seeds", "1:3", "--draw", players["draw"],
                                  "--plumbline", players["identify"]], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        found = {line.split("  ")[1]: line.split()[-6:] for line in run.stdout.splitlines()[1:]}
        inside = {name: (words[0], words[2], words[-1]) for name, words in found.items()}
        self.assertEqual(inside["compliance_per_length_um_N_m"], ("2", "2", "1.00"))
        self.assertEqual(inside["compliance_um_N"], ("0", "2", "3.00"))
        self.assertEqual(inside["tilt_mrad"], ("2", "2", "0.00"))
        self.assertEqual(inside["base_um"], ("2", "2", "0.50"))
        self.assertEqual(inside["K1 x 1.25 m + K2"], ("2", "2", "1.09"))
        self.assertEqual(inside["all"][:2], ("8", "10"))
        self.assertNotIn("length_um", inside)  # a number that was not fitted


if __name__ == "__main__":
    unittest.main()
