"""Each dialect has a page, and what the page takes from the table of the dialect is in step with it."""

import pathlib
import subprocess
import sys
import tempfile
import shutil

ROOT = pathlib.Path(__file__).resolve().parents[2]


def check(root):
    script = root / "scripts" / "dialect_pages.py"
    return subprocess.run([sys.executable, "-B", script, "--check"], capture_output=True, text=True, check=False)


def main():
    tables = sorted(path.stem for path in (ROOT / "grammar").glob("*.toml"))
    pages = sorted(path.stem for path in (ROOT / "docs" / "dialects").glob("*.md"))
    assert tables == pages and len(tables) >= 4, (tables, pages)
    result = check(ROOT)
    assert result.returncode == 0, result.stdout + result.stderr
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder)
        for part in ("scripts", "grammar", "docs/dialects"):
            shutil.copytree(ROOT / part, copy / part)
        table = copy / "grammar" / "okuma.toml"
        table.write_text(table.read_text().replace('does = "rapid"', 'does = "feed"', 1))
        stale = check(copy)
        assert stale.returncode == 1 and "okuma.md" in stale.stdout, stale.stdout + stale.stderr


if __name__ == "__main__":
    main()
