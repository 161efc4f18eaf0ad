"""plumbline.exe under Wine, as if it were a program of this system.

A test that cannot run says why, as the others do (tests/support/skip.hpp): ctest counts it as skipped.
"""
import os
import shutil
import subprocess
import sys
from pathlib import Path

BUILD = Path(os.environ["PLUMBLINE_WINDOWS_BUILD"])
EXE = BUILD / "plumbline.exe"
WINE = next((path for path in ("/usr/lib/wine/wine64", shutil.which("wine64")) if path and os.path.exists(path)), None)


def skip(why):
    print(f"this test is skipped: {why}")
    sys.exit(0)


def require():
    """The environment in which Wine runs, its folder made on the first call."""
    if WINE is None:
        skip("there is no Wine (scripts/setup --with-windows)")
    if not EXE.exists():
        skip(f"there is no {EXE} (cmake --preset windows && cmake --build --preset windows)")
    environment = dict(os.environ, WINEPREFIX=str(BUILD / "wine"), WINEDEBUG="-all", WINEDLLOVERRIDES="mscoree,mshtml=",
                       WINELOADER=WINE)
    if not (BUILD / "wine" / "system.reg").exists():
        subprocess.run([WINE, "wineboot.exe", "--init"], env=environment, check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL, timeout=300)
        serve(environment, "--wait")
    keep_serving(environment)
    return environment


def serve(environment, *words):
    return subprocess.run([shutil.which("wineserver") or "/usr/lib/wine/wineserver64", *words], env=environment,
                          stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=120).returncode


def keep_serving(environment):
    """One server of Wine for all the programs of a test. By itself it ends a few seconds after the last program, and
    takes those with it that begin at that moment: they end with code 1 and say nothing. One that runs already keeps the
    time that it was begun with, so it is ended first: tests under Wine go one after the other."""
    serve(environment, "--kill")
    if serve(environment, "--persistent=120") != 0:
        raise RuntimeError(f"the server of Wine does not start for {environment['WINEPREFIX']}")


def wrapper(folder):
    """A program of this system that is plumbline.exe."""
    path = Path(folder) / "plumbline"
    path.write_text(f'#!/bin/sh\nexec "{WINE}" "{EXE}" "$@"\n')
    path.chmod(0o755)
    return path
