"""The wheel, as pip builds it from the sources and installs it into an environment of its own, with the module that the
build folder already has.

usage: wheel_test.py BUILD
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(sys.argv[1])
USE = """
import plumbline
done = plumbline.compensate("G0 X0 Y0 Z0 A0 B0 C0\\nG1 X20 A5 F500\\nM2\\n", %r, work_offset={"G54": (0, 0, -1008, 0, 0, 0)})
assert done.summary["moves"] == 2 and done.text.startswith("(plumbline " + plumbline.__version__)
assert plumbline.error([(0, 0, -1008, 0, 0, 0)], %r)["dx_um"].shape == (1,)
print(plumbline.__file__)
"""


def run(*command, **how):
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env=environment, **how)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    try:
        import ensurepip  # noqa: F401
        import numpy  # noqa: F401
        import pip  # noqa: F401
    except ModuleNotFoundError as missing:
        print(f"this test is skipped: {missing} (scripts/setup --dev)")
        return 77
    with tempfile.TemporaryDirectory(prefix="plumbline-wheel-") as name:
        folder = Path(name)
        source = folder / "source"
        for kept in ("bindings", "LICENSE", "pyproject.toml", "CMakeLists.txt"):
            copy = shutil.copytree if (ROOT / kept).is_dir() else shutil.copy
            source.mkdir(exist_ok=True)
            copy(ROOT / kept, source / kept)
        run(sys.executable, "-m", "pip", "wheel", "--no-deps", "--no-index", "--no-build-isolation", "--wheel-dir", folder,
            "--config-settings", f"build-dir={BUILD}", source)
        [wheel] = folder.glob("plumbline-*.whl")
        environment = folder / "environment"
        run(sys.executable, "-m", "venv", "--system-site-packages", environment)
        run(environment / "bin/pip", "install", "--no-deps", "--no-index", wheel)
        model = str(ROOT / "models/pm600-like.toml")
        used = run(environment / "bin/python", "-B", "-c", USE % (model, model), cwd=folder)
        assert str(environment) in used, used
    return 0


if __name__ == "__main__":
    sys.exit(main())
