#!/usr/bin/env python3
"""Code made for one kind of processor stays in its unit: no other unit of the program may be linked to a function that
an older processor cannot run, so each unit of the kernel gives away nothing but what kernel_units.hpp declares."""
import platform
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
UNITS = {"kernel_any"}
if platform.machine().lower() in ("x86_64", "amd64"):
    UNITS |= {"kernel_x86_64_v2", "kernel_x86_64_v3", "kernel_x86_64_v4"}
UNIT = re.compile(r"\b(?:correct|play|carry)_(?:one_by_one|on_\w+)\(")


def given_away(library):
    """unit -> the symbols that other units can be linked to."""
    listing = subprocess.run(["nm", "-C", "--defined-only", library], capture_output=True, text=True, check=True).stdout
    units, unit = {}, None
    for line in listing.split("\n"):
        member = re.match(r"(kernel_\w+)\.\S+:$", line)
        if line.endswith(":"):
            unit = member[1] if member else None
            if unit:
                units[unit] = []
        symbol = re.match(r"[0-9a-f]+ (\w) (.*)", line)
        if unit and symbol and (symbol[1].isupper() or symbol[1] in "uvw"):
            units[unit].append(symbol[2])
    return units


def main(library):
    if not shutil.which("nm"):
        print("this test is skipped: no nm is installed")
        return 77
    faults = []
    units = given_away(library)
    declared = UNIT.findall((ROOT / "src/compensate/exact/kernel_units.hpp").read_text())
    if set(units) != UNITS:
        faults.append(f"the units of the library are {sorted(units)}, those of this kind of processor {sorted(UNITS)}")
    for unit, symbols in units.items():
        faults += [f"{unit} gives away {symbol}" for symbol in symbols if not UNIT.search(symbol)]
    named = [symbol for symbols in units.values() for symbol in symbols if UNIT.search(symbol)]
    if len(named) > len(declared) or len(named) < len(units):
        faults.append(f"the units give {named}")
    print("\n".join(faults) or f"{len(units)} units give away {len(named)} functions and nothing else")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
