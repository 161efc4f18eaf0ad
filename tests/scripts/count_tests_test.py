"""The last line and the exit code of scripts/test, from reports of ctest of every kind."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "count_tests.py"
PASSED = '<testcase name="a" status="run"/>'
FAILED = '<testcase name="b" status="fail"><failure message=""/></testcase>'
NOT_BUILT = '<testcase name="c" status="notrun"><skipped message="Unable to find executable"/></testcase>'
SKIPPED = '<testcase name="d" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/></testcase>'
SAYS_WHY = ('<testcase name="f" status="notrun"><skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/>'
            '<system-out>this test is skipped: no such control\n</system-out></testcase>')
IN_PART = '<testcase name="g" status="run"><system-out>this part is skipped: no network\n</system-out></testcase>'
DISABLED = '<testcase name="e" status="disabled"/>'


def lines(cases, ctest_status=0):
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.xml"
        if cases is not None:
            report.write_text(f"<testsuite>{''.join(cases)}</testsuite>")
        command = [sys.executable, SCRIPT, report, str(ctest_status)]
        run = subprocess.run(command, capture_output=True, text=True)
        return run.stdout.splitlines(), run.returncode


def count(cases, ctest_status=0):
    said, status = lines(cases, ctest_status)
    return said[-1], status


class CountTests(unittest.TestCase):
    def test_all_passed(self):
        self.assertEqual(count([PASSED, PASSED]), ("2 passed, 0 failed", 0))

    def test_skipped_are_counted_apart(self):
        self.assertEqual(count([PASSED, SKIPPED, DISABLED]), ("1 passed, 0 failed, 2 skipped", 0))

    def test_what_is_skipped_says_why(self):
        said, status = lines([PASSED, SAYS_WHY, IN_PART])
        self.assertEqual(said, ["skipped: f: no such control", "skipped in part: g: no network",
                                "2 passed, 0 failed, 1 skipped"])
        self.assertEqual(status, 0)

    def test_failures_fail(self):
        self.assertEqual(count([PASSED, FAILED], 8), ("1 passed, 1 failed", 1))

    def test_what_was_not_built_has_failed(self):
        self.assertEqual(count([PASSED, NOT_BUILT]), ("1 passed, 1 failed", 1))

    def test_ctest_itself_failing_fails(self):
        self.assertEqual(count([PASSED], 8), ("1 passed, 0 failed", 1))

    def test_no_test_at_all_fails(self):
        self.assertEqual(count([]), ("0 passed, 0 failed", 1))
        self.assertEqual(count([SKIPPED]), ("0 passed, 0 failed, 1 skipped", 1))
        self.assertEqual(count(None), ("0 passed, 0 failed", 1))


if __name__ == "__main__":
    unittest.main()
