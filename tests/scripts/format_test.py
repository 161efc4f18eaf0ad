"""Every C++ source is formatted as .clang-format says, every shell script parses."""

import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CLANG_FORMAT = shutil.which("clang-format-14") or shutil.which("clang-format")


def files(*folders, suffixes):
    return [path for folder in folders for path in sorted((ROOT / folder).rglob("*")) if path.suffix in suffixes]


def shell_scripts():
    candidates = [p for folder in ("scripts", ".ci", "examples") for p in sorted((ROOT / folder).rglob("*")) if p.is_file()]
    return [path for path in candidates if path.read_bytes().startswith(b"#!/usr/bin/env bash")]


def batches(sources, size=40):
    """Many files a process: to start one takes longer than to look at a file."""
    return [sources[i : i + size] for i in range(0, len(sources), size)]


def complaint(*sources):
    """The first line of what is said against these files; empty: nothing."""
    run = subprocess.run([CLANG_FORMAT, "--dry-run", "-Werror", *sources], capture_output=True, text=True)
    return run.stderr.splitlines()[0] if run.returncode != 0 else ""


def main():
    scripts = shell_scripts()
    assert len(scripts) >= 5, scripts
    failed = [s for s in scripts if subprocess.run(["bash", "-n", s]).returncode != 0]
    sources = files("src", "include", "bindings", "tests", suffixes={".c", ".h", ".cpp", ".hpp"})
    assert len(sources) >= 10, sources
    if CLANG_FORMAT is None:
        print("this test is skipped: clang-format is not installed (scripts/setup --dev)")
        return 1 if failed else 77
    for source in [s for batch in batches(sources) if complaint(*batch) for s in batch]:
        if said := complaint(source):
            failed.append(source)
            print(said)
    for path in failed:
        print(f"not as it should be: {path.relative_to(ROOT)}")
    if failed:
        print(f"clang-format -i {' '.join(str(p.relative_to(ROOT)) for p in failed if p in sources)}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
