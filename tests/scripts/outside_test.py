"""Another project takes plumbline as a folder (add_subdirectory): it configures, and its source finds the headers."""

import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def main():
    with tempfile.TemporaryDirectory(prefix="plumbline-outside-") as folder:
        subprocess.run(["cmake", "-S", ROOT / "tests/outside", "-B", folder, "-G", "Ninja", f"-DPLUMBLINE={ROOT}",
                        "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"], check=True, stdout=subprocess.DEVNULL)
        commands = json.loads((pathlib.Path(folder) / "compile_commands.json").read_text())
        [main_cpp] = [c["command"] for c in commands if c["file"].endswith("tests/outside/main.cpp")]
        subprocess.run(main_cpp + " -fsyntax-only", shell=True, cwd=folder, check=True)
        targets = subprocess.run(["ninja", "-C", folder, "-t", "targets", "all"], check=True, capture_output=True, text=True).stdout
        assert "outside: CXX_EXECUTABLE_LINKER" in targets, "nothing to link"
        assert "nc_test" not in targets, "tests are built for a project that did not ask for them"
    return 0


if __name__ == "__main__":
    sys.exit(main())
