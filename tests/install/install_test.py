#!/usr/bin/env python3
"""Projects outside of plumbline, built against what is installed alone and run: they write what the command writes.

usage: install_test.py --cmake FILE --build DIR --prefix DIR --compiler FILE WHAT
WHAT is `install`, which fills the prefix, or the name of a project below.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
OFFSET = "G54=0,0,-1008,0,0,0"
FLAGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]


def run(*command, **how):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **how)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}\nends with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


class Place:
    """A folder outside of the sources with a project, a model and a program, and the installed prefix."""

    def __init__(self, given, folder):
        self.cmake, self.compiler, self.prefix, self.folder = given.cmake, given.compiler, given.prefix, Path(folder)
        self.c_compiler = shutil.which("gcc") or shutil.which("cc")
        self.library = next(path.parent for path in given.prefix.rglob("libplumbline.a"))
        self.model = shutil.copy(ROOT / "models/pm600-like.toml", self.folder)
        self.program = shutil.copy(HERE / "outside/part.ngc", self.folder)
        self.environment = {"PATH": os.environ["PATH"], "HOME": str(self.folder),
                            "PKG_CONFIG_PATH": str(self.library / "pkgconfig")}

    def project(self, name):
        return shutil.copytree(HERE / "outside" / name, self.folder / name)

    def run(self, *command, shared=False):
        environment = {**self.environment, **({"LD_LIBRARY_PATH": str(self.library)} if shared else {})}
        return run(*command, cwd=self.folder, env=environment)

    def built(self, name, *options):
        """The program of a CMake project."""
        return self.configured(self.project(name), "outside", *options)

    def configured(self, project, program, *options):
        self.run(self.cmake, "-S", project, "-B", project / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}",
                 f"-DCMAKE_CXX_COMPILER={self.compiler}", "-DCMAKE_BUILD_TYPE=Release", *options)
        self.run(self.cmake, "--build", project / "build")
        return project / "build" / program

    def pkg_config(self, package, *what):
        return self.run("pkg-config", *what, package).split()

    def loads(self, program):
        """The shared libraries that a program names."""
        return re.findall(r"\(NEEDED\).*\[(.*)\]", run("readelf", "-d", program))

    def check(self, program, shared=False):
        """Runs the program of a project and compares what it wrote with what the installed command writes."""
        command = self.prefix / "bin/plumbline"
        self.run(command, "compensate", self.program, "-m", self.model, "--work-offset", OFFSET, "-o", "command.ngc")
        said = self.run(program, self.model, self.program, "outside.ngc", shared=shared)
        version = self.run(command, "--version").split()[1]
        assert said.startswith(f"{version}, interface 1: "), said
        assert "nc-unknown-code in line 2" in said, said
        expected = (self.folder / "command.ngc").read_bytes()
        assert (self.folder / "outside.ngc").read_bytes() == expected and len(expected) > 1000


def install(given):
    shutil.rmtree(given.prefix, ignore_errors=True)
    run(given.cmake, "--install", given.build, "--prefix", given.prefix)
    files = [path for path in given.prefix.rglob("*") if path.is_file()]
    texts = [path for path in files if path.suffix in (".cmake", ".pc", ".hpp", ".h")]
    assert len(texts) >= 8, files
    for path in texts:
        text = path.read_text()
        assert str(ROOT) not in text and str(given.build) not in text, f"{path} names the sources"
        includes = re.findall(r'#include [<"](.*?)[>"]', text) if path.suffix in (".hpp", ".h") else []
        foreign = [name for name in includes if "/" in name and not name.startswith("plumbline/")]
        assert not foreign, f"{path} includes {foreign}"
    assert not list(given.prefix.rglob("libplumbline_*")), "modules are part of the one library"
    schemas = {path.name for path in (given.prefix / "share/plumbline/schemas").iterdir()}
    assert schemas == {path.name for path in (ROOT / "docs/schemas").iterdir()} and len(schemas) > 10, schemas


def cmake_static(place):
    program = place.built("cpp")
    assert not any(name.startswith("libplumbline") for name in place.loads(program))
    place.check(program)


def cmake_shared(place):
    program = place.built("cpp", "-DBUILD_SHARED_LIBS=ON")
    loaded = place.loads(program)
    assert "libplumbline.so.1" in loaded and not any("ceres" in name or "fmt" in name for name in loaded), loaded
    place.check(program)  # its run path names the library


def pkg_config_shared(place):
    program = place.folder / "outside"
    flags = place.pkg_config("plumbline", "--cflags", "--libs")
    place.run(place.compiler, "-std=c++17", *FLAGS, place.project("cpp") / "main.cpp", "-o", program, *flags)
    assert "libplumbline.so.1" in place.loads(program)
    place.check(program, shared=True)


def pkg_config_static(place):
    program = place.folder / "outside"
    flags = place.pkg_config("plumbline-static", "--cflags", "--libs")
    place.run(place.compiler, "-std=c++17", *FLAGS, place.project("cpp") / "main.cpp", "-o", program, *flags)
    assert not any(name.startswith("libplumbline") for name in place.loads(program))
    place.check(program)


def c_shared(place):
    program = place.folder / "outside"
    flags = place.pkg_config("plumbline", "--cflags", "--libs")
    place.run(place.c_compiler, "-std=c99", "-pedantic", *FLAGS, place.project("c") / "main.c", "-o", program, *flags)
    assert "libplumbline.so.1" in place.loads(program)
    place.check(program, shared=True)


def c_cmake(place):
    """A project in C alone names no C++."""
    for kind in ("static", "shared"):
        shutil.rmtree(place.folder / "c", ignore_errors=True)
        program = place.built("c", f"-DCMAKE_C_COMPILER={place.c_compiler}", f"-DKIND={kind}")
        assert ("libplumbline.so.1" in place.loads(program)) == (kind == "shared")
        place.check(program)


def documented(place):
    """The examples of docs/library.md."""
    page = (ROOT / "docs/library.md").read_text()
    blocks = dict(re.findall(r"^```(cmake|cpp|c)\n(.*?)^```$", page, re.MULTILINE | re.DOTALL))
    project = place.folder / "documented"
    project.mkdir()
    (project / "CMakeLists.txt").write_text(blocks["cmake"])
    (project / "straighten.cpp").write_text(blocks["cpp"])
    program = place.configured(project, "straighten")
    command = place.prefix / "bin/plumbline"
    place.run(command, "compensate", place.program, "-m", place.model, "--work-offset", OFFSET, "--tolerance", "1um",
              "-o", "command.ngc")
    with open(place.program) as text, open(place.folder / "documented.ngc", "wb") as corrected:
        said = subprocess.run([program, place.model], stdin=text, stdout=corrected, stderr=subprocess.PIPE, text=True,
                              check=True).stderr
    assert re.search(r"at most 13\.1\d+ um are left", said), said
    assert (place.folder / "documented.ngc").read_bytes() == (place.folder / "command.ngc").read_bytes()
    (place.folder / "straighten.c").write_text(blocks["c"])
    program = place.folder / "straighten"
    flags = place.pkg_config("plumbline", "--cflags", "--libs")
    place.run(place.c_compiler, "-std=c99", "-pedantic", *FLAGS, "straighten.c", "-o", program, *flags)
    place.run(command, "compensate", place.program, "-m", place.model, "--work-offset", OFFSET, "-o", "command.ngc")
    said = place.run(program, place.model, place.program, shared=True)
    assert said == (place.folder / "command.ngc").read_text()


def exports(place):
    """The shared library shows its interface and nothing else."""
    library = place.library / "libplumbline.so"
    listing = run("nm", "-D", "--defined-only", library)
    symbols = [line.split()[-1].split("@")[0] for line in listing.splitlines()]
    interface = re.compile(r"plumbline_\w+|PLUMBLINE_1|_Z(N|NK|TIN|TSN|TVN)9plumbline3api2v1\w+")
    foreign = [symbol for symbol in symbols if not interface.fullmatch(symbol)]
    assert not foreign, foreign
    assert sum("compensate" in symbol for symbol in symbols) >= 2, symbols
    header = (place.prefix / "include/plumbline/plumbline.h").read_text()
    declared = set(re.findall(r"PLUMBLINE_API [^;(]*?(plumbline_\w+)\(", header))
    shown = {symbol for symbol in symbols if symbol.startswith("plumbline_")}
    assert declared == shown and len(declared) > 25, declared ^ shown
    assert re.search(r"\(SONAME\).*\[libplumbline\.so\.1\]", run("readelf", "-d", library))


PROJECTS = {"cmake static": cmake_static, "cmake shared": cmake_shared, "pkg-config shared": pkg_config_shared,
            "pkg-config static": pkg_config_static, "c": c_shared, "c cmake": c_cmake, "documented": documented, "exports": exports}


def main():
    parser = argparse.ArgumentParser()
    for name in ("cmake", "build", "prefix", "compiler"):
        parser.add_argument(f"--{name}", type=Path, required=True)
    parser.add_argument("what")
    given = parser.parse_args()
    if given.what == "install":
        return install(given)
    if given.what.startswith("pkg-config") and not shutil.which("pkg-config"):
        print("this test is skipped: pkg-config is not installed (scripts/setup --dev)")
        return 77
    with tempfile.TemporaryDirectory(prefix="plumbline-outside-") as folder:
        PROJECTS[given.what](Place(given, folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())
