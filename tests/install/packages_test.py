#!/usr/bin/env python3
"""The packages for Debian and the sources in one file, as scripts/packages makes them.

usage: packages_test.py --build DIR --packages DIR --cmake FILE WHAT
WHAT is `made`, which makes them of what the build folder has and looks at them, `clean`, which installs them on a clean
Debian, or `sources`.
"""
import argparse
import os
import re
import shutil
import stat
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OFFSET = "G54=0,0,-1008,0,0,0"
VERSION = re.search(r"project\(plumbline VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
LIBRARY = "libplumbline" + re.search(r"set\(PLUMBLINE_INTERFACE (\d+)\)", (ROOT / "cmake/library.cmake").read_text())[1]
TRIPLET = f"{os.uname().machine}-linux-gnu"
RUNTIME = {"libc6", "libfmt9", "libgcc-s1", "libstdc++6"}
# What each package needs beside of the others, and a file for which it is installed.
PACKAGES = {"plumbline": (RUNTIME, "usr/bin/plumbline"), LIBRARY: (RUNTIME, f"usr/lib/{TRIPLET}/libplumbline.so.1"),
            "libplumbline-dev": ({LIBRARY, "libfmt-dev"}, "usr/include/plumbline/plumbline.hpp"),
            "python3-plumbline": (RUNTIME | {"python3", "python3-numpy"}, "usr/lib/python3/dist-packages/plumbline/__init__.py")}


def run(*command, **how):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **how)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}\nends with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def skip(reason):
    print(f"this test is skipped: {reason}")
    return 77


def make(given, folder, *options, umask=0o022):
    shutil.rmtree(folder, ignore_errors=True)
    run(ROOT / "scripts/packages", "--no-setup", "--into", folder, *options, umask=umask)
    return {path.name: path for path in folder.iterdir() if path.is_file()}


def depends(fields):
    """{name: [(relation, version)]} of the field Depends."""
    needed = {}
    for word in fields["Depends"].split(", "):
        name, relation, version = re.fullmatch(r"(\S+)(?: \((\S+) (\S+)\))?", word).groups()
        needed.setdefault(name, []).append((relation, version))
    return needed


def check_fields(name, path):
    text = run("dpkg-deb", "--field", path)
    fields = dict(re.findall(r"^(\S+): (.*)$", text, re.MULTILINE))
    architecture = run("dpkg", "--print-architecture").strip()
    assert path.name == f"{name}_{VERSION}_{architecture}.deb", path
    assert (fields["Version"], fields["Architecture"], fields["Source"]) == (VERSION, architecture, "plumbline"), fields
    assert fields["Maintainer"] and fields["Section"] in ("science", "libs", "libdevel", "python"), fields
    described = re.search(r"^Description: (.*)\n((?: .*\n)+)", text, re.MULTILINE)
    assert "hexapod" in described[1] and len(described[2].splitlines()) > 4, text
    assert all(len(line) <= 80 for line in described[0].splitlines()[1:]), text
    needed = depends(fields)
    assert set(needed) == PACKAGES[name][0], needed
    for other, versions in needed.items():
        here = VERSION if other in PACKAGES else run("dpkg-query", "-W", "-f", "${Version}", other)
        for relation, version in versions:
            assert relation is None or subprocess.run(["dpkg", "--compare-versions", here, relation, version]).returncode == 0, needed
    if name == "libplumbline-dev":
        assert needed[LIBRARY] == [("=", VERSION)], needed
    return set(needed)


def check_members(name, path):
    """Owner and permissions of each file, whatever the umask was."""
    with subprocess.Popen(["dpkg-deb", "--fsys-tarfile", path], stdout=subprocess.PIPE) as packed:
        members = list(tarfile.open(fileobj=packed.stdout, mode="r|"))
    programs = {"./usr/bin/plumbline"}
    for member in members:
        wanted = 0o777 if member.issym() else 0o755 if member.isdir() or member.name in programs else 0o644
        assert (member.uid, member.gid, stat.S_IMODE(member.mode)) == (0, 0, wanted), (name, member.name, oct(member.mode))
        assert re.match(r"\./usr(/|$)", member.name), member.name
    return {member.name for member in members if not member.isdir()}


def check_binary(path, needs):
    """Stripped, and each library that it loads is of a package that it needs."""
    assert ".symtab" not in run("readelf", "-S", "-W", path), f"{path} is not stripped"
    for library in re.findall(r"\(NEEDED\).*\[(.*)\]", run("readelf", "-d", path)):
        owner = run("dpkg", "-S", f"*/{TRIPLET}/{library}").split(":")[0]
        assert owner in needs, f"{path} loads {library} of {owner}"


def check_contents(folder, needs, given):
    for path in folder.rglob("*"):
        if path.is_symlink() or path.is_dir():
            continue
        data = path.read_bytes()
        for place in (ROOT, given.build, given.packages):
            assert str(place).encode() not in data, f"{path.relative_to(folder)} names {place}"
        if data.startswith(b"\x7fELF"):
            check_binary(path, needs)
        assert path.parent.name != "man1" or data.startswith(b"\x1f\x8b"), f"{path} is not compressed"


def check_use(prefix, given):
    """The program and the module of Python, from the folder that all packages are unpacked into."""
    usr, model = prefix / "usr", prefix / "usr/share/plumbline/models/pm600-like.toml"
    command = usr / "bin/plumbline"
    program = shutil.copy(Path(__file__).parent / "outside/part.ngc", prefix)
    options = [program, "-m", model, "--work-offset", OFFSET, "-o"]
    assert run(command, "--version") == run(given.build / "plumbline", "--version")
    run(command, "compensate", *options, prefix / "installed.ngc")
    run(given.build / "plumbline", "compensate", *options, prefix / "built.ngc")
    expected = (prefix / "built.ngc").read_bytes()
    assert (prefix / "installed.ngc").read_bytes() == expected and len(expected) > 1000
    use = ("import importlib.metadata, plumbline, sys; done = plumbline.compensate(sys.argv[1], sys.argv[2], "
           "work_offset={'G54': (0, 0, -1008, 0, 0, 0)}); assert importlib.metadata.version('plumbline') == sys.argv[3]; "
           "open(sys.argv[4], 'wb').write(done.bytes); print(plumbline.__file__)")
    used = run("/usr/bin/python3", "-B", "-c", use, program, model, VERSION, prefix / "python.ngc",
               env={"PATH": os.environ["PATH"], "PYTHONPATH": str(usr / "lib/python3/dist-packages")})
    assert used.startswith(str(usr)) and (prefix / "python.ngc").read_bytes() == expected, used
    libraries = usr / "lib" / TRIPLET
    flags = run("pkg-config", "--cflags", "--libs", "plumbline",
                env={"PATH": os.environ["PATH"], "PKG_CONFIG_PATH": str(libraries / "pkgconfig")}).split()
    assert os.path.samefile(flags[0][2:], usr / "include") and os.path.samefile(flags[1][2:], libraries), flags
    soname = re.search(r"\(SONAME\).*\[(.*)\]", run("readelf", "-d", libraries / "libplumbline.so"))[1]
    assert LIBRARY == soname.replace(".so.", "") and (libraries / soname).exists(), soname


def differences(one, other):
    """What tells two packages apart: files of both kinds, and how they stand in the lists."""
    with tempfile.TemporaryDirectory(prefix="plumbline-packages-") as scratch:
        for which, path in (("one", one), ("other", other)):
            run("dpkg-deb", "--raw-extract", path, Path(scratch) / which)
            (Path(scratch) / which / "contents").write_text(run("dpkg-deb", "--contents", path))
        return subprocess.run(["diff", "-r", "one", "other"], cwd=scratch, capture_output=True, text=True).stdout[:5000]


def made(given):
    files = make(given, given.packages, "--from", given.build, umask=0o077)
    debs = {name.split("_")[0]: path for name, path in files.items() if name.endswith(".deb")}
    assert set(debs) == set(PACKAGES), debs
    owners = {}
    with tempfile.TemporaryDirectory(prefix="plumbline-packages-") as scratch:
        prefix = Path(scratch) / "all"
        for name, path in debs.items():
            needs = check_fields(name, path)
            inside = check_members(name, path)
            for file in inside:
                assert owners.setdefault(file, name) == name, f"{file} is in {name} and in {owners[file]}"
            assert f"./{PACKAGES[name][1]}" in inside, inside
            for folder in (Path(scratch) / name, prefix):
                run("dpkg-deb", "--extract", path, folder)
            check_contents(Path(scratch) / name, needs, given)
            licence = (prefix / "usr/share/doc" / name / "copyright").read_text()
            assert licence.startswith((ROOT / "LICENSE").read_text()) and "Mozilla Public License" in licence, name
        check_use(prefix, given)
    # CPack counts folders in Installed-Size, and a folder's size is that of its file system
    with tempfile.TemporaryDirectory(prefix="again-", dir=given.packages.parent) as beside:
        again = make(given, Path(beside) / "packages", "--from", given.build)
        assert set(again) == set(files), again
        for name, path in again.items():
            if path.read_bytes() != files[name].read_bytes():
                raise AssertionError(f"{name} made twice is not the same:\n{differences(files[name], path)}")
    return 0


def clean(given):
    """Prints what the script says; its last line is why, where it could not be tried."""
    done = subprocess.run([ROOT / "scripts/try_packages", "--program", given.build / "plumbline", given.packages],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(done.stdout)
    if done.returncode == 77:
        return skip(done.stdout.splitlines()[-1].split("not tried: ")[-1])
    assert done.returncode == 0 and "all of it works: 4 packages" in done.stdout, done.returncode
    return 0


def sources(given):
    """They are what git has in this commit, and can be built: nothing that a build reads is missing."""
    asked = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, capture_output=True, text=True)
    if not (ROOT / ".git").exists() or asked.returncode != 0:
        return skip(f"this folder is no checkout of git {asked.stderr.strip()}")
    with tempfile.TemporaryDirectory(prefix="plumbline-sources-") as scratch:
        folder = Path(scratch)
        name = f"plumbline-{VERSION}.tar.gz"
        [packed] = make(given, folder / "once", "--sources").values()
        assert packed.name == name
        assert packed.read_bytes() == make(given, folder / "twice", "--sources", umask=0o077)[name].read_bytes()
        run("tar", "-xzf", packed, "-C", folder)
        unpacked = folder / f"plumbline-{VERSION}"
        kept = run("git", "ls-tree", "-r", "-z", "HEAD", cwd=ROOT).split("\0")[:-1]
        wanted = {line.split("\t")[1]: line.startswith("100755") for line in kept}
        there = {path.relative_to(unpacked).as_posix(): bool(path.stat().st_mode & 0o111)
                 for path in unpacked.rglob("*") if not path.is_dir()}
        assert there == wanted and len(there) > 500, set(there.items()) ^ set(wanted.items())
        run(given.cmake, "--preset", "dev", cwd=unpacked)  # each source by itself
        read = [path for path in run("ninja", "-C", unpacked / "build/dev", "-t", "inputs", "all").splitlines()
                if path.startswith(f"{unpacked}/") and not path.startswith(f"{unpacked}/build/")]
        missing = [path for path in read if not Path(path).exists()]
        assert len(read) > 300 and not missing, (len(read), missing)
    return 0


def main():
    parser = argparse.ArgumentParser()
    for name in ("build", "packages", "cmake"):
        parser.add_argument(f"--{name}", type=Path, required=True)
    parser.add_argument("what", choices=("made", "clean", "sources"))
    given = parser.parse_args()
    needed = ["git", "gzip", "ninja"] if given.what == "sources" else ["dpkg-deb", "dpkg-shlibdeps", "file", "pkg-config", "readelf"]
    missing = [tool for tool in needed if shutil.which(tool) is None]
    if missing:
        return skip(f"not installed: {', '.join(missing)} (scripts/setup --dev)")
    return {"made": made, "clean": clean, "sources": sources}[given.what](given)


if __name__ == "__main__":
    sys.exit(main())
