"""Prints the last line of scripts/test from ctest's report: count_tests.py REPORT.xml EXIT-CODE-OF-CTEST.

A test that was not run because it could not be (not built, no such program) has failed; one that says itself that it
cannot run here (no LinuxCNC) is skipped. Each that is skipped, whole or in part, is listed with the reason that it
printed after "this test is skipped: " or "this part is skipped: "."""

import re
import sys
import xml.etree.ElementTree as xml


def outcome(case):
    if case.get("status") == "run":
        return "passed"
    skipped = case.find("skipped")
    if case.get("status") == "disabled":
        return "skipped"
    if skipped is not None and skipped.get("message", "").startswith("SKIP_"):
        return "skipped"
    return "failed"


def reasons(case):
    return re.findall(r"this (?:test|part) is skipped: (.*)", case.findtext("system-out") or "")


def main(report, ctest_status):
    try:
        cases = list(xml.parse(report).getroot().iter("testcase"))
    except (OSError, xml.ParseError) as error:
        print(f"no report of the tests: {error}", file=sys.stderr)
        cases = []
    count = {"passed": 0, "failed": 0, "skipped": 0}
    for case in cases:
        count[outcome(case)] += 1
        why = "; ".join(sorted(set(reasons(case))))
        if outcome(case) != "passed":
            print(f"{outcome(case)}: {case.get('name')}" + (f": {why}" if why else ""))
        elif why:
            print(f"skipped in part: {case.get('name')}: {why}")
    line = f"{count['passed']} passed, {count['failed']} failed"
    if count["skipped"]:
        line += f", {count['skipped']} skipped"
    print(line, flush=True)
    return 1 if ctest_status != 0 or count["failed"] or not count["passed"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2])))
