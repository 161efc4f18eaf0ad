"""Outputs of plumbline in JSON, of every kind, made of the project's own models and measurements."""
import ctypes
import json
import os
import pathlib
import shutil
import subprocess
import tomllib
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[2]
OFFSET = ("--work-offset", "G54=0,0,-1008,0,0,0")
TABLE = ("--tools", "tools.toml", "--keeps-position", "M6")
PATIENCE = 600

ARCS = """G21 G90 G94
T1 M6
G43 H1
G0 X0 Y0 Z5 A0 B0 C0
G1 Z0 F500
G1 X20.5 Y10.25 A5 B-2.5 C1
G2 X30.5 Y20.25 I5 J5
G3 X60 Y20 I14.75 J0 A1
G2 X60 Y-140 I0 J-80 F2000
G1 X61 Y-141 F60000
M2
"""
CALLS = """G21 G90 G94
G0 X0 Y0 Z5 A0 B0 C0
G64
G1 Z0 F50000
o<slot> call [20] [9000]
G4 P0.5
G1 X0.01
G1 X0.02
G1 X0.001
"""
LINES = """G21 G90 G94
T2 M6
G43 H2
G0 X0 Y0 Z5 A0 B0 C0
G1 X0.2 F500
M2
"""
SLOT = """o<slot> sub
#3 = 0
o1 while [#3 LT 2]
G1 X#1 Y#3 F#2
G1 X0
#3 = [#3 + 1]
o1 endwhile
o<slot> endsub
M2
"""
CUTS_IN_SLOT = """G21 G90 G94
G0 X0 Y0 Z5 A0 B0 C0
o<slot> call [1] [50000]
M2
"""
LEAVES_TO_SLOT = """G21 G90 G94
G0 X0 Y0 Z0 A0 B0 C0
G53 G0 Z0
o<slot> call [20] [900]
M2
"""
STORES = """G21 G90
G0 X0 Y0 Z0 A0 B0 C0
G1 X50 F1000
G28.1
M2
"""
PROBES = """G21 G90
G0 X0 Y0 Z5 A0 B0 C0
G38.2 Z-5 F100
M2
"""
PECKS = """G54 G0 X0 Y0 Z60 A0 B0 C0
S1000 M3 F200
CYCLE83(50,0,2,-30,,-10,,3,0.5,0.2,0.5,1)
M30
"""
TOO_FAR = """G21 G90
G0 X0 Y0 Z0 A0 B0 C0
G53 G0 Z0
G0 X10
G0 Z300
G0 X2000
G1 X0 A89 F500
M2
"""
TOOLS = """plumbline = "tools 1"
[[tool]]
number = 1
name = "ball end mill"
length_mm = 85
mass_kg = 1.4
centre_of_mass_mm = 22
[[tool]]
number = 2
length_mm = 60
"""
SETTINGS = """plumbline = "settings 1"
[machines.first]
model = "machine.toml"
[machines.first.work_offset]
G54 = [0, 0, -1008, 0, 0, 0]
"""


class Output(NamedTuple):
    schema: str  # name of its file, without what all end with
    what: str
    value: object


def kind_of(value):
    """Of an object with a mark: the name of its schema."""
    return value["plumbline"].replace(" ", "-")


class Folder:
    """Where the outputs are made."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.outputs = []
        self.environment = {**os.environ, "XDG_CONFIG_HOME": "/nonexistent", "LC_ALL": "C.UTF-8"}
        self.environment.pop("PLUMBLINE_SETTINGS", None)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return name

    def take(self, schema, what, value):
        self.outputs.append(Output(schema, what, value))
        return value

    def run(self, *words, code=0):
        """Messages on standard error are outputs, too."""
        words = [os.environ["PLUMBLINE_PROGRAM"], "--diagnostics=json", *map(str, words)]
        done = subprocess.run(words, cwd=self.folder, env=self.environment, capture_output=True, text=True,
                              timeout=PATIENCE)
        if done.returncode != code:
            raise AssertionError(f"{' '.join(words)} ends with {done.returncode}\n{done.stdout}{done.stderr}")
        for line in done.stderr.splitlines():
            self.take("message", words[2], json.loads(line))
        return done.stdout

    def json_of(self, command, *words, code=0, schema=None):
        value = json.loads(self.run(command, *words, "--json", "-", code=code))
        return self.take(schema or kind_of(value), " ".join(map(str, (command, *words))), value)

    def runs(self, folder, case, which, without=(), change=None):
        """Some runs of a case of tests/blind as a dataset of their own, columns that begin with `without` left out.
        change(number of the run, what is said of it, its rows)."""
        source = ROOT / "tests/blind" / case / "data"
        said = tomllib.loads((source / "dataset.toml").read_text())
        runs = said.pop("run")
        text = "".join(f"{key} = {json.dumps(value)}\n" for key, value in said.items())
        for number in which:
            run = runs[number]
            rows = [line.split(",") for line in (source / run["file"]).read_text().split()]
            kept = [i for i, column in enumerate(rows[0]) if not any(column.startswith(name) for name in without)]
            rows = [[row[i] for i in kept] for row in rows]
            if change:
                change(number, run, rows)
            text += "\n[[run]]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in run.items())
            self.write(f"{folder}/{run['file']}", "".join(",".join(row) + "\n" for row in rows))
        return self.write(f"{folder}/dataset.toml", text)


def of_programs(made):
    """compensate, check, diff, settings, trace and batch."""
    shutil.copy(ROOT / "tests/blind/open-01/base.toml", made.folder / "machine.toml")
    stand_in = (ROOT / "models/pm600-like.toml").read_text()
    certain = made.write("certain.toml", stand_in.partition("[uncertainty]")[0])
    slow = made.write("slow.toml", stand_in + "\n[control]\nblock_time_ms = 5\n")
    texts = {"arcs.ngc": ARCS, "lines.ngc": LINES, "calls.ngc": CALLS, "slot.ngc": SLOT, "stores.ngc": STORES,
             "probes.ngc": PROBES, "far.ngc": TOO_FAR, "cuts.ngc": CUTS_IN_SLOT, "leaves.ngc": LEAVES_TO_SLOT,
             "end.ngc": "M2\n", "tools.toml": TOOLS, "pecks.mpf": PECKS}
    for name, text in texts.items():
        made.write(name, text)
    where = ("-m", "machine.toml", *OFFSET)

    made.json_of("compensate", "arcs.ngc", *where, *TABLE, "--tolerance", "0.5um", "-o", "arcs-c.ngc")
    made.json_of("compensate", "arcs.ngc", "-m", slow, *OFFSET, *TABLE, "--tolerance", "0.2um", "--yields", "time",
                 "--touch-off", "0,0,-1000,0,0,0", "--guard", "-o", "arcs-s.ngc")
    made.json_of("compensate", "lines.ngc", *where, *TABLE, "--tolerance", "1um", "-o", "lines-c.ngc")
    made.json_of("compensate", "calls.ngc", "-m", slow, *OFFSET, "-o", "calls-s.ngc")
    made.json_of("compensate", "calls.ngc", "-m", certain, *OFFSET, "-o", "calls-c.ngc", "--no-read-back")
    made.json_of("compensate", "cuts.ngc", "-m", slow, *OFFSET, "-o", "cuts-s.ngc")
    made.json_of("compensate", "end.ngc", *where, "-o", "end-c.ngc")
    made.json_of("check", "far.ngc", "-m", "machine.toml", *OFFSET, code=3)
    made.json_of("check", "leaves.ngc", "-m", "machine.toml", *OFFSET, code=3)
    made.json_of("check", "calls.ngc", "-m", certain, *OFFSET)
    made.json_of("check", "stores.ngc", *where)
    made.json_of("diff", "arcs.ngc", "arcs-c.ngc", *where, *TABLE)
    made.json_of("diff", "arcs.ngc", "far.ngc", *where, *TABLE)
    made.json_of("diff", "end.ngc", "end.ngc")

    made.write("inside/plumbline.toml", SETTINGS)
    shutil.copy(made.folder / "machine.toml", made.folder / "inside/machine.toml")
    made.write("inside/part.ngc", PROBES)
    made.json_of("settings", "inside/part.ngc", "--machine", "first", "--tolerance", "1um")
    made.json_of("settings")
    made.json_of("compensate", "inside/part.ngc", "--machine", "first", "-o", "part-c.ngc")

    for program in ("arcs.ngc", "calls.ngc", "probes.ngc", "pecks.mpf"):
        for line in made.run("trace", program, *TABLE).splitlines():
            made.take("motion", f"trace {program}", json.loads(line))

    parts = {"a.nc": CALLS, "slot.ngc": SLOT, "refused.nc": "G0 X1 X2\n", "gone.nc": CALLS, "read.txt": "no program\n"}
    for name, text in parts.items():
        made.write(f"parts/{name}", text)
    batch = ("batch", "parts", *where, "--endings", "nc,ngc", "-o", "out", "--json")
    for _ in range(2):
        made.run(*batch, "batch.jsonl", code=1)
        for line in (made.folder / "batch.jsonl").read_text().splitlines():
            value = json.loads(line)
            made.take(kind_of(value), "batch", value)
        (made.folder / "parts/gone.nc").unlink(missing_ok=True)
    made.run("-v", "restore", "arcs-c.ngc", "-o", "x.ngc", code=1)
    made.run("simulate", "far.ngc", "--no-such-option", code=2)


def spoil(number, run, rows):
    """What inspect is to find."""
    if number == 0:
        run["payload_kg"] = 20
    if number == 1:
        rows[20][2] = "900"
    if number == 3:
        rows[1:] = [[*row[:3], "5.00", *row[4:]] for row in rows[1:]]


def of_measurements(made):
    """inspect, compare, circularity, identify, calibrate, plan and diagnose."""
    blind = ROOT / "tests/blind"
    model = blind / "open-01/base.toml"
    both = made.runs("both", "open-01", range(8))
    bar = made.runs("bar", "open-01", range(8), without=("torque",))
    torques = made.runs("torques", "open-01", range(8), without=("radial",))
    spoilt = made.runs("spoilt", "open-01", range(8), change=spoil)
    twice = made.runs("twice", "open-01", (0, 2))
    shutil.copy(made.folder / "twice/01-p1-ccw.csv", made.folder / "twice/03-p2-ccw.csv")

    made.json_of("inspect", "-d", spoilt, "-m", model, code=3)
    made.json_of("inspect", "-d", twice, code=3)
    made.json_of("inspect", "-d", both, "-m", model)
    made.json_of("compare", "-m", model, "-d", both, "--beside", ROOT / "models/pm600-like.toml", schema="comparison")
    made.json_of("compare", "-m", model, "-d", torques, schema="comparison")
    made.json_of("compare", "-m", model, "-d", bar, schema="comparison")
    made.json_of("circularity", "-d", both)
    made.json_of("circularity", "-d", torques)

    few = made.runs("few", "open-01", range(4))
    made.json_of("identify", "-m", model, "-d", few, "-o", "identified.toml", "--force", "--free", "cyclic.phase_deg")
    stiff = made.write("stiff.toml", model.read_text().replace("compliance_um_N = 0.00782", "compliance_um_N = 0.002"))
    made.json_of("identify", "-m", stiff, "-d", both, "-o", "refused.toml", code=1)
    made.json_of("identify", "-m", model, "-d", both, "-o", "paper.toml", "--stages", "paper", "--force")
    made.json_of("calibrate", "-m", model, "--poses", tracked(made, model), "-o", "calibrated.toml", "--force")
    made.json_of("compensate", "arcs.ngc", "-m", "identified.toml", *OFFSET, *TABLE, "-o", "arcs-i.ngc")
    made.json_of("plan", "-m", model, "-n", 2, "--candidates", 30, "--for", "elasticity", "--radius", "120,200")
    made.json_of("plan", "-m", model, "-n", 2, "--candidates", 30, "--for", "tip", "--tilts", "0,10")
    made.json_of("plan", "-m", model, "-n", 2, "--candidates", 30, "--separate", "backlash,cyclic")

    narrow = made.write("narrow.toml", model.read_text().replace("[-300, 300]", "[-10, 10]"))  # no circle fits in
    loads = made.runs("loads", "open-14", range(2), without=("radial",))
    hertz = made.runs("hertz", "open-09", range(8))
    joined = made.runs("bar-alone", "open-14", range(2), without=("torque",))
    made.take("diagnosis-1", "diagnose --with", json.loads(
        made.run("diagnose", "-m", blind / "open-14/base.toml", "-d", loads, "--with", joined, "-o", "joined", "--json")))
    for machine, dataset in ((model, both), (narrow, bar), (model, torques), (model, spoilt),
                             (blind / "open-14/base.toml", loads), (blind / "open-09/base.toml", hertz)):
        folder = f"found-{pathlib.Path(dataset).parent}"
        made.take("diagnosis-1", f"diagnose {dataset}",
                  json.loads(made.run("diagnose", "-m", machine, "-d", dataset, "-o", folder, "--json")))
        for name in ("diagnosis", "inspection"):
            value = json.loads((made.folder / folder / f"{name}.json").read_text())
            made.take(kind_of(value), f"{folder}/{name}.json", value)


def tracked(made, model):
    """A table of a tracker that sees the tip where `error` says on a machine whose base joint 2 stands elsewhere."""
    columns = ["x_mm", "y_mm", "z_mm", "a_deg", "b_deg", "c_deg"]
    poses = [(i % 5 * 70 - 140, i % 4 * 80 - 120, -900 - i % 7 * 40, i % 3 * 14 - 14, i % 6 * 5 - 12, i % 2 * 8)
             for i in range(40)]
    made.write("poses.csv", "".join(",".join(map(str, row)) + "\n" for row in (columns, *poses)))
    base = [[0, 0, 0], [9, 0, 0], *[[0, 0, 0]] * 4]
    effect = f'[[effect]]\nname = "joint-position"\nbase_um = {base}\nplatform_um = {[[0, 0, 0]] * 6}\n'
    made.write("true.toml", f"{model.read_text()}\n{effect}")
    lines = [line.split(",") for line in made.run("error", "poses.csv", "-m", "true.toml").split()]
    at = lines[0].index("dx_um")
    text = ",".join([*columns, *(f"measured_{column}" for column in columns)]) + "\n"
    for i, row in enumerate(lines[1:]):
        place = [float(row[k]) + float(row[at + k]) / 1000 for k in range(3)]
        turned = [float(row[k]) + 1e-4 * (i % 3 - 1) for k in range(3, 6)]
        text += ",".join([*row[:6], *(f"{value:.7f}" for value in place + turned)]) + "\n"
    return made.write("tracker.csv", text)


class Input(ctypes.Structure):
    """plumbline_input."""
    _fields_ = [("name", ctypes.c_char_p), ("text", ctypes.c_char_p), ("size", ctypes.c_size_t)]

    @classmethod
    def file(cls, path):
        return cls(os.fsencode(path), None, 0)


def of_the_library(made, library):
    """What the library alone gives as JSON, by its interface for C. After of_programs."""
    lib = ctypes.CDLL(library)
    for name, gives in (("context_new", ctypes.c_void_p), ("options_new", ctypes.c_void_p), ("result_text", ctypes.c_char_p),
                        ("error", ctypes.c_char_p)):
        getattr(lib, f"plumbline_{name}").restype = gives
    context = ctypes.c_void_p(lib.plumbline_context_new())

    def called(name, *given):
        """The result of a function, which it leaves behind its arguments."""
        result = ctypes.c_void_p()
        if getattr(lib, f"plumbline_{name}")(context, *given, ctypes.byref(result)) != 0:
            raise AssertionError(f"{name}: {lib.plumbline_error(context)}")
        return result

    def options(**given):
        made_of = ctypes.c_void_p(lib.plumbline_options_new())
        for name, value in given.items():
            lib.plumbline_options_set(context, made_of, name.replace("_", "-").encode(), value.encode())
        return made_of

    def take(what, result):
        value = json.loads(lib.plumbline_result_text(result, 0, None))
        made.take(kind_of(value), what, value)

    poses = Input(b"poses", text := b"x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n0,0,-1008,0,0,0\n", len(text))
    for model in ("machine.toml", "certain.toml"):
        machine = called("model_read", ctypes.byref(Input.file(made.folder / model)))
        program = Input.file(made.folder / "calls.ngc")
        offset = options(work_offset="G54=0,0,-1008,0,0,0")
        take("simulate", called("simulate", ctypes.byref(program), machine, offset, None))
        take("error", called("error_csv", ctypes.byref(poses), machine, None))
    take("new_model", called("new_model", options(base_radius="950", base_angles="50,70,170,190,290,310", home="0,0,-1008",
                                                  platform_radius="185", platform_angles="0,120,120,240,240,0")))
    missing = ctypes.c_void_p()
    if lib.plumbline_model_read(context, ctypes.byref(Input.file("none.toml")), ctypes.byref(missing)) != 1:
        raise AssertionError("a model that is not there is refused")
    made.take("message", "the library", json.loads(lib.plumbline_error(context)))
