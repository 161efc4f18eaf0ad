"""Folders of small programs for the tests of `plumbline batch`, and the command run on them."""
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLUMBLINE = os.environ["PLUMBLINE_PROGRAM"]
MODEL = ROOT / "models/pm600-like.toml"
# Nobody's own settings.
ENVIRONMENT = {**os.environ, "XDG_CONFIG_HOME": "/nonexistent"}
ENVIRONMENT.pop("PLUMBLINE_SETTINGS", None)

SETTINGS = f"""plumbline = "settings 1"
model = "{MODEL}"
[work_offset]
G54 = [0, 0, -1008, 0, 0, 0]
"""


def program(number, moves=6):
    """Some moves, other ones for each number."""
    lines = ["G21 G90 G94", "G0 X0 Y0 Z5 A0 B0 C0", "G1 Z0 F900"]
    lines += [f"G1 X{number % 50 + i / 4} Y{i / 5} Z-{i / 10} A{i % 3} B{number % 5} F1200" for i in range(moves)]
    return "\n".join([*lines, "M2", ""])


def make(folder, count, moves=6, in_each=100):
    """`count` programs in folders of `in_each`; gives their paths in the folder."""
    names = [f"{i // in_each:03}/part-{i:05}.nc" for i in range(count)]
    for i, name in enumerate(names):
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(program(i, moves))
    (folder / "plumbline.toml").write_text(SETTINGS)
    return names


def batch(*words, **how):
    how = {"capture_output": True, "text": True, "env": ENVIRONMENT, **how}
    return subprocess.run([PLUMBLINE, "batch", *map(str, words)], **how)


def texts(folder):
    """All files that are not hidden, by their paths in the folder."""
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in folder.rglob("*") if path.is_file() and not path.name.startswith(".")}
