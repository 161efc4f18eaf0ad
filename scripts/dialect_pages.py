#!/usr/bin/env python3
"""Writes into the pages of docs/dialects what the tables of grammar/ say: sources, settings, order, codes, refusals.

dialect_pages.py [--check]

What stands outside of the marks is written by hand. With --check nothing is written; the exit code is 1 where a page is
not in step with its table. Standard library only."""

import pathlib
import re
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
BEGIN = "<!-- from grammar/{}.toml, by scripts/dialect_pages.py -->"
END = "<!-- end of that -->"

MEANINGS = {
    "absolute": "absolute words",
    "incremental": "incremental words",
    "no_hole": "to above the hole, and no further",
    "no_next_tool": "the tool change to come takes no tool",
    "return_level": "level that cycles go back to",
    "tool_tip_off": "tool-tip mode off: the tool's length is stated anew",
    "tolerance_cycle": "tolerances of the path, goes through as it stands",
    "transformation": "states the tool-tip mode, goes through as it stands",
    "tool_tip_on": "tool-tip mode, with H the tool's length",
    "arc_centre_absolute": "absolute centres of arcs",
    "arc_centre_incremental": "centres of arcs from their start",
    "arc_ccw": "arc, counterclockwise",
    "arc_cw": "arc, clockwise",
    "arc_through_point": "circle through a point",
    "called_cycle": "drilling cycle, its values in brackets",
    "call_macro": "call of a macro with arguments",
    "call_program": "call of a subprogram",
    "change_tool": "tool change",
    "clear_position": "offset of G92 cleared",
    "compensation_off": "cutter compensation off",
    "compensation_on": "cutter compensation: refused where it acts",
    "continuous": "path without stops",
    "cubic_spline": "cubic spline",
    "coolant": "coolant",
    "cycle": "canned cycle",
    "dwell": "dwell",
    "end": "end of the program",
    "end_program": "end of a subprogram",
    "exact_path": "exact path",
    "exact_stop": "exact stop",
    "exact_stop_once": "exact stop of one block",
    "feed": "straight move at feed",
    "feed_group": "axes whose path F counts",
    "position_spindle": "spindle at an angle, where it stands",
    "main_spindle": "main spindle: the first alone",
    "speed_limit": "limit of the spindle's speed",
    "frame_added": "shift or turn, added",
    "frame_new": "shift or turn",
    "forget_modes": "kept modes forgotten",
    "go_home": "to a stored position",
    "home_or_unit": "with a home position there; alone a statement of the unit",
    "inches": "inches",
    "inverse_time": "inverse time",
    "local_shift": "local shift",
    "lose_position": "to a position that only the machine knows",
    "machine_coordinates": "machine coordinates, one block",
    "millimetres": "millimetres",
    "modal_call": "cycle called after each move; alone: no more",
    "motion_off": "no motion mode",
    "nurbs_end": "end of a NURBS",
    "nurbs_point": "point of a NURBS",
    "no_motion": "read, moves nothing, goes through as it stands",
    "surface_speed": "speed of the surface, or of the spindle",
    "orient_spindle": "spindle orientation",
    "override": "overrides on and off",
    "per_minute": "feed per minute",
    "per_revolution": "feed per revolution",
    "plane_xy": "plane XY",
    "plane_yz": "plane YZ",
    "plane_zx": "plane ZX",
    "probe": "probing",
    "quadratic_spline": "quadratic spline",
    "rapid": "rapid move",
    "read_input": "input read",
    "restore_modes": "kept modes back",
    "restore_position": "offset of G92 back",
    "retract_to_r": "cycles end at R",
    "retract_to_start": "cycles end where they began",
    "rigid_tap": "tapping in step with the spindle",
    "save_modes": "modes kept",
    "save_modes_of_call": "modes kept for a subprogram",
    "set_analog_output": "analog output",
    "set_output": "output",
    "set_position": "position set",
    "set_table": "offsets and tools set",
    "set_tool": "tool in the spindle stated",
    "set_work_table": "work offsets set",
    "spindle": "spindle on and off",
    "stop": "stop",
    "store_home": "position stored",
    "suspend_position": "offset of G92 off",
    "synchronised": "move in step with the spindle",
    "tool_length": "tool length",
    "tool_length_added": "tool length added",
    "tool_length_by_words": "tool length by words",
    "tool_length_off": "tool length off",
    "swivel": "a tilted plane and the tool along its Z, with zeros alone its end",
    "tilted_plane": "a tilted plane",
    "tool_on_plane": "the tool along the Z of the tilted plane",
    "turn_off": "turn of the coordinates off",
    "turn_on": "turn of the coordinates",
    "work_system": "work system",
    "work_system_by_word": "work system by its number",
    "work_system_of_block": "work system of one block",
}


def rows_of(table):
    for key, letter in (("g", "G"), ("m", "M"), ("names", "")):
        for row in table.get(key, []):
            code = letter + row["code"]
            yield row, f"{code} to {letter}{row['last']}" if "last" in row else code


def grouped(pairs):
    """What belongs to each key, in the order of first sight."""
    groups = {}
    for key, code in pairs:
        groups.setdefault(key, []).append(code)
    return groups


def table_of(head, groups):
    lines = [f"| {head} | codes |", "|---|---|"]
    return lines + [f"| {key} | {', '.join(codes)} |" for key, codes in groups.items()]


def sources_of(text, table):
    """What the tags stand for, or the comment that the table begins with."""
    if "sources" in table:
        return "\n".join(["| tag | source |", "|---|---|"] + [f"| {k} | {v} |" for k, v in table["sources"].items()])
    lines = []
    for line in text.splitlines():
        if not line.startswith("#"):
            break
        lines.append(line[1:].strip())
    return " ".join(lines)


def settings_of(text):
    for line in text.splitlines():
        match = re.match(r"\s*([^#]*?)\s*#\s*(.*\(setting.*)$", line)
        if match and match[1]:
            yield match[1].rstrip(","), re.sub(r"\s*\(setting\)\s*", " ", match[2]).strip()


def part_of(name):
    text = (ROOT / "grammar" / f"{name}.toml").read_text(encoding="utf-8")
    table = tomllib.loads(text)
    rows = list(rows_of(table))
    unknown = {row["does"] for row, _ in rows} - MEANINGS.keys() - {"refused"}
    if unknown:
        raise SystemExit(f"scripts/dialect_pages.py: MEANINGS has nothing for {', '.join(sorted(unknown))}")
    order = table["execution"]
    at = order.index("motion")
    before, after = order[:at], order[at + 1 :]
    lines = [BEGIN.format(name), "", "## Sources", "", sources_of(text, table)]
    settings = list(settings_of(text))
    if settings:
        lines += ["", "## What no source said", "", "| in the table | taken for granted |", "|---|---|"]
        lines += [f"| `{what}` | {why or 'what is met most often'} |" for what, why in settings]
    lines += ["", "## Order inside a block", ""]
    lines += [f"{', '.join(before)}, then the **motion**, then {', '.join(after)}.".replace("_", " ")]
    lines += ["", "## What is read", ""]
    lines += table_of("meaning", grouped((MEANINGS[r["does"]], c) for r, c in rows if r["does"] in MEANINGS))
    told = grouped((r["source"], c) for r, c in rows if "source" in r)
    if told:
        lines += ["", "## Where it says so", ""] + table_of("source", told)
    refused = grouped(
        [(r["why"], c) for r, c in rows if r["does"] not in MEANINGS]
        + [(r["why"], c.replace("*", " and digits")) for r in table.get("reserved", []) for c in r["words"].split()]
    )
    if refused:
        lines += ["", "## What is refused", ""] + table_of("the code ...", refused)
    first, last = table["user_m_codes"]
    lines += ["", f"M{first} to M{last}, as far as they do not stand above, belong to the machine's builder, and are refused"]
    lines += ["unless `--pass` lets them through. Any other code is refused as unknown.", "", END]
    return "\n".join(lines)


def main():
    check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not check:
        raise SystemExit(__doc__)
    stale = []
    for source in sorted((ROOT / "grammar").glob("*.toml")):
        page = ROOT / "docs" / "dialects" / f"{source.stem}.md"
        text = page.read_text(encoding="utf-8")
        begin, end = text.find(BEGIN.format(source.stem)), text.find(END)
        if begin < 0 or end < begin:
            raise SystemExit(f"{page}: the marks of the part from the table are missing")
        written = text[:begin] + part_of(source.stem) + text[end + len(END) :]
        if written == text:
            continue
        stale.append(page.name)
        if not check:
            page.write_text(written, encoding="utf-8")
    if check and stale:
        print(f"not in step with grammar/: {', '.join(stale)}; run scripts/dialect_pages.py")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
