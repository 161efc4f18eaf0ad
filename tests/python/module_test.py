"""import plumbline: what the command writes, from Python."""
import ast
import concurrent.futures
import decimal
import json
import os
import pickle
import re
import signal
import subprocess
import sys
import tempfile
import threading
import traceback
import unittest
from pathlib import Path

try:
    import numpy as np
except ModuleNotFoundError as missing:
    print(f"this test is skipped: {missing} (scripts/setup --dev)")
    sys.exit(77)

import plumbline

ROOT = Path(__file__).resolve().parents[2]
MODEL = ROOT / "models/pm600-like.toml"
PROGRAM = ROOT / "tests/install/outside/part.ngc"
OFFSET = {"G54": (0, 0, -1008, 0, 0, 0)}
PART = "G0 X0 Y0 Z0 A0 B0 C0\nG1 X20 A5 F500\nM2\n"


def command(*words):
    return subprocess.run([os.environ["PLUMBLINE_PROGRAM"], *map(str, words)], capture_output=True, check=True).stdout


def marked(number):
    """For plumbline.map: any function of a module."""
    if number == 3:
        raise plumbline.Refused('{"code": "x-y", "message": "", "help": "", "file": "", "line": 0, "column": 0, "length": 1, '
                                '"text": ""}', "three")
    return number * 10


def without_posterior(model):
    """The text of a model file without the name of the file that lies beside it."""
    return re.sub(r"\[posterior\]\n(?:\w+ = .*\n)+\n", "", model.read_text())


class Jobs(unittest.TestCase):
    def test_each_executor_gives_the_same_in_order_and_refusals_in_their_place(self):
        jobs = [{"program": PART.replace("X20", f"X{x}"), "model": plumbline.Model(MODEL), "work_offset": OFFSET}
                for x in (20, 5, "5 X6", 30)]
        here = list(plumbline.map(jobs))
        self.assertEqual(here[2].code, "nc-word-twice")
        with concurrent.futures.ThreadPoolExecutor(2) as threads:
            by_threads = list(plumbline.map(jobs, threads))
        with concurrent.futures.ProcessPoolExecutor(2) as processes:
            by_processes = list(plumbline.map(iter(jobs), processes))
        for others in (by_threads, by_processes):
            self.assertEqual(others[2].diagnostic, here[2].diagnostic)
            for i in (0, 1, 3):
                self.assertEqual(others[i].bytes, here[i].bytes)
                self.assertEqual(others[i].summary, here[i].summary)

    def test_other_functions(self):
        done = list(plumbline.map(({"number": n} for n in range(5)), function=marked))
        self.assertEqual([str(one) if n == 3 else one for n, one in enumerate(done)], [0, 10, 20, "three", 40])

    def test_results_go_between_processes_with_the_model_that_they_hold(self):
        made = plumbline.new_model(base_radius=1000, base_angles=(-5, 5, 115, 125, 235, 245), platform_radius=300,
                                   platform_angles=(-55, 55, 65, 175, 185, 295), home=(0, 0, 900))
        self.assertEqual(pickle.loads(pickle.dumps(made)).model, made.model)
        done = pickle.loads(pickle.dumps(plumbline.compensate(PART, MODEL, work_offset=OFFSET)))
        self.assertIn("compensated this program", done.text)
        again = pickle.loads(pickle.dumps(done))
        self.assertEqual(again.summary, done.summary)
        self.assertEqual(done.summary["made_of"]["model_hash"], plumbline.Model(MODEL).hash)


class Programs(unittest.TestCase):
    def setUp(self):
        self.model = plumbline.Model(MODEL)

    def test_text_and_path_become_what_the_command_writes(self):
        expected = command("compensate", PROGRAM, "-m", MODEL, "--work-offset", "G54=0,0,-1008,0,0,0", "--tolerance",
                           "1um", "-o", "-", "--no-settings")
        by_path = plumbline.compensate(PROGRAM, MODEL, work_offset=OFFSET, tolerance="1um")
        by_text = plumbline.compensate(PROGRAM.read_text(), self.model, work_offset=["G54=0,0,-1008,0,0,0"],
                                       tolerance="1um")
        self.assertEqual(by_path.bytes, expected)
        self.assertEqual(by_text.text, expected.decode())
        self.assertEqual(by_path.summary["plumbline"], "compensation 1")
        self.assertEqual(by_path.summary["moves"], 12)
        self.assertIn("condition number", by_path.words)

    def test_bytes_that_are_no_utf8_come_through(self):
        part = PART.encode().replace(b"M2", b"(\xfc)\nM2")
        done = plumbline.compensate(part, self.model, work_offset=OFFSET, undo=True)
        self.assertIn(b"(\xfc)", done.bytes)
        self.assertEqual(plumbline.restore(done.text, done.undo).encode("utf-8", "surrogateescape"), part)

    def test_models_and_tools_may_be_text(self):
        tools = 'plumbline = "tools 1"\n[[tool]]\nnumber = 3\nlength_mm = 85\n'
        part = "T3 M6\nG43\nG0 X0 Y0 Z0 A0 B0 C0\nG1 X20 A5 F500\nM2\n"
        done = plumbline.compensate(part, MODEL.read_text(), work_offset=OFFSET, tools=tools, keeps_position="M6",
                                    start=(0, 0, 100, 0, 0, 0))
        self.assertIn("tool 3: length 85 mm", done.text)
        self.assertEqual(pickle.loads(pickle.dumps(self.model)).hash, self.model.hash)

    def test_check_diff_and_trace(self):
        self.assertFalse(plumbline.check(PART, self.model, work_offset=OFFSET).found)
        done = plumbline.compensate(PART, self.model, work_offset=OFFSET)
        self.assertTrue(plumbline.diff(PART, done.text, work_offset=OFFSET).found)
        self.assertFalse(plumbline.diff(PART, done.text, work_offset=OFFSET, tolerance_mm=1, tolerance_deg=1).found)
        motion = plumbline.trace(PART)
        self.assertEqual([one["line"] for one in motion], [1, 2])
        self.assertEqual(motion[1]["to"], [20, 0, 0, 5, 0, 0])

    def test_threads_work_at_once_and_progress_ends_the_work(self):
        program = "G0 X0 Y0 Z0 A0 B0 C0\nF500\n" + "G1 X1\nG1 X0\n" * 5000
        texts = [None] * 4

        def work(i):
            texts[i] = plumbline.compensate(program, self.model, work_offset=OFFSET).text

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(set(texts)), 1)
        self.assertIsNotNone(texts[0])

        class Enough(Exception):
            pass

        def stop(done, total):
            self.assertLessEqual(done, total)
            raise Enough

        with self.assertRaises(Enough):
            plumbline.compensate(program, self.model, work_offset=OFFSET, progress=stop)
        with self.assertRaisesRegex(TypeError, "progress: expected a function"):
            plumbline.compensate(program, self.model, work_offset=OFFSET, progress=3)

    @unittest.skipUnless(hasattr(signal, "setitimer"), "no timer of the system raises signals here")
    def test_a_signal_ends_the_work_before_it_is_done(self):
        """As Ctrl-C does: the handler of Python runs while the program is read, not after all of it is done."""
        program = plumbline.Text("G0 X0 Y0 Z0 A0 B0 C0\nF500\n" + "G1 X1\nG1 X0\n" * 20000)

        class Enough(Exception):
            pass

        def stop(*_):
            raise Enough

        before = signal.signal(signal.SIGALRM, stop)
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        for function in (plumbline.compensate, plumbline.check, plumbline.simulate):
            signal.setitimer(signal.ITIMER_REAL, 0.01)
            within = []
            try:
                function(program, self.model, work_offset=OFFSET)
            except Enough as enough:
                within = [frame.name for frame in traceback.extract_tb(enough.__traceback__)]
            self.assertIn("_nobody_is_told", within, function.__name__)

    def test_what_is_text_and_what_is_none(self):
        for program in (bytearray(PART.encode()), memoryview(PART.encode()), PART.encode()):
            self.assertEqual(plumbline.trace(program), plumbline.trace(PART))
        for empty in ("", b""):
            with self.assertRaises(plumbline.Refused) as caught:
                plumbline.check(empty, self.model)
            self.assertEqual(caught.exception.code, "file-empty")
        with self.assertRaisesRegex(TypeError, "a text is a str or bytes, not NoneType"):
            plumbline.Text(None, "part.ngc")
        exact = {"G54": [decimal.Decimal(one) for one in ("0", "0", "-1008.0", "0", "0", "0")]}
        self.assertEqual(plumbline.compensate(PART, self.model, work_offset=exact).text,
                         plumbline.compensate(PART, self.model, work_offset=OFFSET).text)


class Tables(unittest.TestCase):
    def test_error_at_poses_is_the_golden_table(self):
        golden = np.genfromtxt(ROOT / "tests/golden/pm600-like-static.csv", delimiter=",", names=True)
        poses = np.column_stack([golden[name] for name in ("x_mm", "y_mm", "z_mm", "a_deg", "b_deg", "c_deg")])
        table = plumbline.error(poses, MODEL)
        self.assertEqual(table.values.shape, (len(golden), len(table.columns)))
        for name in golden.dtype.names:
            np.testing.assert_allclose(table[name], golden[name], rtol=1e-6, atol=1e-4)
        with self.assertRaises(KeyError):
            table["nothing"]
        with self.assertRaises(ValueError):
            plumbline.error(np.zeros((3, 5)), MODEL)
        with self.assertRaisesRegex(ValueError, "not finite"):
            plumbline.error([(0, 0, -1008, 0, float("nan"), 0)], MODEL)
        with self.assertRaises(ValueError):
            plumbline.error("poses.csv", MODEL)

    def test_simulate_is_the_table_of_the_command(self):
        lines = command("simulate", PROGRAM, "-m", MODEL, "--work-offset", "G54=0,0,-1008,0,0,0",
                        "--no-settings").decode().splitlines()
        table = plumbline.simulate(PROGRAM, MODEL, work_offset=OFFSET)
        self.assertEqual(table.columns, lines[0].split(","))
        self.assertEqual(len(table), len(lines) - 1)
        last = lines[-1].split(",")
        self.assertAlmostEqual(table["dz_um"][-1], float(last[table.columns.index("dz_um")]), places=3)
        self.assertEqual(set(table["motion"]), {0, 1, 2})


class Errors(unittest.TestCase):
    def test_exceptions_carry_the_diagnostic(self):
        with self.assertRaises(plumbline.Refused) as caught:
            plumbline.compensate(plumbline.Text("G0 X0 Y0 Z0 A0 B0 C0\nG1 A60 F100\n", "part.ngc"), MODEL,
                                 work_offset=OFFSET)
        error = caught.exception
        self.assertEqual((error.code, error.file, error.line), ("limit-tilt", "part.ngc", 2))
        self.assertTrue(str(error).startswith("part.ngc:2:"))
        self.assertTrue(error.help)
        self.assertIn(error.code, plumbline.explain(error.code))
        self.assertEqual(pickle.loads(pickle.dumps(error)).diagnostic, error.diagnostic)

    def test_wrong_usage_is_a_value_error(self):
        for wrong in ({"tolerence": "1um"}, {"work_offset": "G54=1"}, {"tolerance": "1um", "step_length": 1}):
            with self.assertRaises(ValueError) as caught:
                plumbline.check(PART, MODEL, **wrong)
            self.assertEqual(caught.exception.code, "usage-wrong")
        with self.assertRaises(plumbline.WrongUsage):
            plumbline.check(PART)
        with self.assertRaises(plumbline.Refused) as caught:
            plumbline.check("no-such-file.ngc", MODEL)
        self.assertEqual(caught.exception.code, "file-missing")


class Learning(unittest.TestCase):
    def dataset(self, folder):
        """Circles as the model itself measures them."""
        command("plan", "-m", MODEL, "-o", folder / "plan", "-n", "4", "--samples", "40", "--for", "masses")
        command("simulate", "-m", MODEL, "-d", folder / "plan/dataset.toml", "-o", folder / "data")
        return folder / "data/dataset.toml"

    def test_compare_and_identify_give_what_the_command_writes(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            dataset = self.dataset(folder)
            command("compare", "-m", MODEL, "-d", dataset, "--json", folder / "c.json")
            self.assertEqual(plumbline.compare(MODEL, dataset).summary, json.loads((folder / "c.json").read_text()))
            self.assertFalse(plumbline.compare(MODEL, dataset, max_radial_um=1).found)
            command("identify", "-m", MODEL, "-d", dataset, "-o", folder / "m.toml")
            self.assertEqual(plumbline.identify(MODEL, dataset).model, without_posterior(folder / "m.toml"))
            with self.assertRaises(plumbline.Refused) as caught:
                plumbline.diagnose(MODEL, folder / "none.toml")
            self.assertEqual(caught.exception.code, "file-missing")

    def test_a_diagnosis_is_the_one_of_the_command(self):
        blind = ROOT / "tests/blind/open-08"
        found = plumbline.diagnose(blind / "base.toml", blind / "data/dataset.toml")
        with tempfile.TemporaryDirectory() as name:
            command("diagnose", "-m", blind / "base.toml", "-d", blind / "data/dataset.toml", "-o", name, "-q")
            self.assertEqual(found.summary, json.loads((Path(name) / "diagnosis.json").read_text()))
            self.assertEqual(found.model, without_posterior(Path(name) / "model.toml"))

    def test_datasets_are_joined(self):
        blind = ROOT / "tests/blind/open-08"
        more = os.fspath(blind / "holdout/dataset.toml")
        alone = plumbline.compare(blind / "base.toml", blind / "data/dataset.toml")
        both = plumbline.compare(blind / "base.toml", blind / "data/dataset.toml", with_=[more])
        self.assertEqual(len(both.summary["runs"]), len(alone.summary["runs"]) + 6)

    def test_new_model_says_what_it_assumes(self):
        made = plumbline.new_model(name="shop", base_radius=600, base_angles=(0, 30, 120, 150, 240, 270),
                                   platform_radius=200, platform_angles=(345, 45, 105, 165, 225, 285),
                                   home=(0, 0, -900), **{"strut.motor_mass_kg": 5})
        self.assertIn("platform.mass_kg", made.summary["assumed"])
        self.assertNotIn("strut.motor_mass_kg", made.summary["assumed"])
        self.assertEqual(plumbline.Model(made.model).name, "shop")


class Stubs(unittest.TestCase):
    def test_the_stubs_name_what_there_is(self):
        stub = ast.parse((Path(plumbline.__file__).parent / "__init__.pyi").read_text())
        named = {node.name for node in stub.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
        self.assertEqual(named | {"INTERFACE"}, set(plumbline.__all__))
        self.assertTrue((Path(plumbline.__file__).parent / "py.typed").exists())
        self.assertEqual(command("--version").decode().split()[1], plumbline.__version__)


if __name__ == "__main__":
    unittest.main()
