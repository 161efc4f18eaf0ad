"""Another project takes plumbline as a folder (add_subdirectory): it configures, its source finds the headers and
nothing else of plumbline, neither its options of the compiler nor its tests; it links, and its program does its work.

outside_test.py BUILD   the folder that plumbline itself was built in. What the other project would compile of plumbline
                        is shown to be compiled there by the same commands; their objects are taken from there.
"""

import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
AS_THERE = ["CMAKE_BUILD_TYPE", "CMAKE_CXX_COMPILER", "CMAKE_CXX_FLAGS", "CMAKE_CXX_FLAGS_RELWITHDEBINFO",
            "CMAKE_UNITY_BUILD", "CMAKE_UNITY_BUILD_BATCH_SIZE", "PLUMBLINE_SANITIZE", "PLUMBLINE_WARNINGS_AS_ERRORS"]


def as_there(build):
    """The settings that decide how plumbline is compiled, as `build` has them."""
    cache = dict(re.findall(r"^(\w+):\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.M))
    return [f"-D{name}={cache[name]}" for name in AS_THERE if name in cache]


def compilations(folder):
    """Object, named from `folder` -> the words of its command."""
    commands = {}
    for entry in json.loads((folder / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        commands[words[words.index("-o") + 1]] = words
    return commands


def check_main(words):
    flags = {word for word in words[1:words.index("-o")] if word.startswith(("-I", "-D", "-std", "-W", "-i", "-m"))}
    assert flags - {"-DNDEBUG", "-std=gnu++17"} == {f"-I{ROOT}/include", "-DPLUMBLINE_STATIC"}, flags


def take(own, build, folder):
    """Puts the objects of `build` where `folder` would compile them to, the commands being the same."""
    there = compilations(build)
    taken = 0
    for object_name, words in own.items():
        if "outside.dir" in object_name:
            continue
        inside = object_name.removeprefix("plumbline/")
        assert inside in there, f"not compiled here: {object_name}"
        same = [word.replace(f"{folder}/plumbline/", f"{build}/").replace(object_name, inside) for word in words]
        assert same == there[inside], f"compiled otherwise:\n{' '.join(same)}\n{' '.join(there[inside])}"
        if (build / inside).exists():
            (folder / object_name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(build / inside, folder / object_name)
            taken += 1
    return taken


def link(folder):
    """Runs the commands that lead to `outside`, but those that compile what was taken."""
    commands = subprocess.run(["ninja", "-C", folder, "-t", "commands", "outside"], check=True, capture_output=True,
                              text=True).stdout.splitlines()
    left_out = 0
    for command in commands:
        if " -c " in command and "outside.dir" not in command and " -o " in command:
            left_out += 1
            continue
        made = subprocess.run(command, shell=True, cwd=folder, capture_output=True, text=True)
        assert made.returncode == 0, f"{command}\n{made.stdout}{made.stderr}"
    return left_out


def main(build):
    with tempfile.TemporaryDirectory(prefix="plumbline-outside-") as name:
        folder = pathlib.Path(name).resolve()
        settings = as_there(build)
        subprocess.run(["cmake", "-S", ROOT / "tests/outside", "-B", folder, "-G", "Ninja", f"-DPLUMBLINE={ROOT}",
                        "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *settings], check=True, stdout=subprocess.DEVNULL)
        own = compilations(folder)
        check_main(next(words for name, words in own.items() if "outside.dir" in name))
        targets = subprocess.run(["ninja", "-C", folder, "-t", "targets", "all"], check=True, capture_output=True, text=True).stdout
        assert "outside: CXX_EXECUTABLE_LINKER" in targets, "nothing to link"
        assert "nc_test" not in targets, "tests are built for a project that did not ask for them"
        install = (folder / "cmake_install.cmake").read_text()
        assert "libplumbline" not in install, "plumbline is installed by a project that did not ask for it"
        taken = take(own, build, folder)
        if any(re.match("-DPLUMBLINE_SANITIZE=.", setting) for setting in settings):
            return 0  # what is sanitized links with what is sanitized
        assert 20 < link(folder) <= taken, "some objects were not there"
        output = folder / "out.ngc"
        said = subprocess.run([folder / "outside", ROOT / "models/pm600-like.toml", ROOT / "tests/install/outside/part.ngc", output],
                              check=True, capture_output=True, text=True).stdout
        assert ": 12 moves" in said and output.stat().st_size > 1000, said
    return 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
