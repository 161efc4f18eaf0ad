"""Every relative link of a page in this project leads to a file that is there."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def pages():
    yield from sorted(ROOT.glob("*.md"))
    for folder in ("docs", "src", "examples", "tests", "grammar", "models"):
        yield from sorted((ROOT / folder).rglob("*.md"))


def main():
    links = broken = 0
    for page in pages():
        text = re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL)
        for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", text):
            if re.match(r"[a-z]+:", target):
                continue
            links += 1
            if not (page.parent / target).exists():
                broken += 1
                print(f"{page.relative_to(ROOT)}: no {target}")
    assert links > 10, "the pages have lost their links"
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
