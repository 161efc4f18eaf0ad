"""Another project takes plumbline as a folder (add_subdirectory): it configures, its source finds the headers and
nothing else of plumbline, neither its options of the compiler nor its tests. With --build it is built and run, too."""

import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def check_command(main_cpp, folder):
    words = shlex.split(main_cpp)
    flags = [word for word in words[1:words.index("-o")] if word.startswith("-")]
    assert set(flags) <= {f"-I{ROOT}/include", "-DPLUMBLINE_STATIC", "-std=gnu++17"}, flags
    subprocess.run(main_cpp + " -fsyntax-only", shell=True, cwd=folder, check=True)


def main(build):
    with tempfile.TemporaryDirectory(prefix="plumbline-outside-") as folder:
        subprocess.run(["cmake", "-S", ROOT / "tests/outside", "-B", folder, "-G", "Ninja", f"-DPLUMBLINE={ROOT}",
                        "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=0"],
                       check=True, stdout=subprocess.DEVNULL)
        commands = json.loads((pathlib.Path(folder) / "compile_commands.json").read_text())
        check_command(next(c["command"] for c in commands if "outside.dir" in c["command"]), folder)
        targets = subprocess.run(["ninja", "-C", folder, "-t", "targets", "all"], check=True, capture_output=True, text=True).stdout
        assert "outside: CXX_EXECUTABLE_LINKER" in targets, "nothing to link"
        assert "nc_test" not in targets, "tests are built for a project that did not ask for them"
        install = (pathlib.Path(folder) / "cmake_install.cmake").read_text()
        assert "libplumbline" not in install, "plumbline is installed by a project that did not ask for it"
        if build:
            made = subprocess.run(["ninja", "-C", folder, "outside"], capture_output=True, text=True)
            assert made.returncode == 0, made.stdout
            output = pathlib.Path(folder) / "out.ngc"
            said = subprocess.run([pathlib.Path(folder) / "outside", ROOT / "models/pm600-like.toml",
                                   ROOT / "tests/install/outside/part.ngc", output],
                                  check=True, capture_output=True, text=True).stdout
            assert ": 12 moves" in said and output.stat().st_size > 1000, said
    return 0


if __name__ == "__main__":
    sys.exit(main("--build" in sys.argv[1:]))
