#!/usr/bin/env python3
"""The house: how large files, functions, folders and classes may be, and that each source has its test."""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LINES_OF_FILE, LINES_OF_FUNCTION, FILES_OF_FOLDER, PRIVATE_METHODS = 400, 60, 35, 12
TESTED = 0.9

# Folders of alike things may be as long as the list of these things.
ALIKE = {"src/physics/effects": "one file an effect"}

NARROW_PATH = re.compile(r"\b(?:fs|filesystem)::path\((?![\")])")
KEYWORD = re.compile(r"\s*(if|for|while|switch|else|do|catch|return|case|namespace|struct|class|enum|union|try|TEST_CASE|SECTION)\b")


def sources(top, endings=(".cpp", ".hpp", ".re")):
    return sorted(p for p in (ROOT / top).rglob("*") if p.suffix in endings)


def functions(text):
    """(first line, number of lines, head) of each function body that starts outside of other functions."""
    lines = text.split("\n")
    i = 0
    while i < len(lines):
        line = lines[i]
        indent = len(line) - len(line.lstrip(" "))
        if line.endswith("{") and indent <= 4 and not KEYWORD.match(line) and not re.search(r"=\s*\{$|\[\d*\]\s*=?\s*\{$", line):
            head = line
            k = i
            while "(" not in head and k > 0 and i - k < 6 and not re.search(r"[;{}]$|^$", lines[k - 1]):
                k -= 1
                head = lines[k] + head
            end = next((j for j in range(i + 1, len(lines)) if lines[j].startswith(" " * indent + "}")
                        and not lines[j].startswith(" " * (indent + 1))), None)
            if "(" in head and not head.lstrip().startswith(('"', "OptionRow", "[")) and end is not None and not re.search(r"\b(namespace|struct|class|enum|union)\b[^()]*\{$", line):
                yield i + 1, end - i + 1, head.strip()
                i = end
        i += 1


def private_methods(text):
    """(name, how many) of each class."""
    lines = text.split("\n")
    for i, line in enumerate(lines):
        found = re.match(r"( *)(?:template <.*> )?(class|struct) (\w+)(?: final)?(?: :.*)? \{$", line)
        if not found:
            continue
        indent = len(found[1])
        end = next(j for j in range(i + 1, len(lines)) if lines[j].startswith(" " * indent + "};"))
        private = found[2] == "class"
        count = 0
        j = i + 1
        while j < end:
            body = lines[j]
            access = re.match(r" *(public|private|protected):", body)
            if access:
                private = access[1] != "public"
            elif re.match(" " * (indent + 2) + r"[^ /}#]", body):
                statement = body
                while not re.search(r"[;{}]\s*(//.*)?$", lines[j]) and j + 1 < end:
                    j += 1
                    statement += " " + lines[j].strip()
                if lines[j].rstrip().endswith("{"):  # an inline body or a nested type: to its end
                    close = next((k for k in range(j + 1, end) if lines[k].startswith(" " * (indent + 2) + "}")), j)
                    j = close
                nested = re.match(r" *(template <.*> )?(struct|class|enum|union|using|friend|static constexpr|static_assert)\b", statement)
                method = re.search(r"[\w~\]=<>!+*-]\(", statement) and not re.match(r"[^(]*=\s", statement)
                callback = re.match(r" *(std::function|const std::function)", statement)
                if private and method and not nested and not callback:
                    count += 1
            j += 1
        yield found[3], count


def main():
    wrong = []
    for path in sources("src") + sources("tests"):
        text = path.read_text()
        name = path.relative_to(ROOT)
        if text.count("\n") > LINES_OF_FILE:
            wrong.append(f"{name}: {text.count(chr(10))} lines, at most {LINES_OF_FILE}")
        for line, size, head in functions(text) if name.parts[0] == "src" else ():
            if size > LINES_OF_FUNCTION:
                wrong.append(f"{name}:{line}: {size} lines in a function, at most {LINES_OF_FUNCTION}: {head[:70]}")
        for of, count in private_methods(text) if name.parts[0] == "src" else ():
            if count > PRIVATE_METHODS:
                wrong.append(f"{name}: {of} has {count} private methods, at most {PRIVATE_METHODS}")
        if name.as_posix() != "src/base/files/path_of.hpp" and name.parts[0] == "src":
            wrong += [f"{name}:{text.count(chr(10), 0, m.start()) + 1}: path_of() makes a path of a name in UTF-8"
                      for m in NARROW_PATH.finditer(text)]
    folders = {p.parent for p in sources("src")}
    for folder in sorted(folders):
        files = [p for p in folder.iterdir() if p.suffix in (".cpp", ".hpp", ".re")]
        name = folder.relative_to(ROOT).as_posix()
        if len(files) > FILES_OF_FOLDER and name not in ALIKE:
            wrong.append(f"{name}: {len(files)} files, at most {FILES_OF_FOLDER}")
    without = []
    all_of = sources("src", (".cpp",))
    for path in all_of:
        mirror = ROOT / "tests" / path.relative_to(ROOT / "src").parent
        if (mirror / f"{path.stem}_test.cpp").exists():
            continue
        beside = [p for p in mirror.glob("*_test.cpp")] if mirror.exists() else []
        if any(re.search(rf"\b{path.stem}\b", p.read_text()) for p in beside):
            continue
        without.append(path.relative_to(ROOT).as_posix())
    tested = 1 - len(without) / len(all_of)
    print(f"{100 * tested:.1f} % of {len(all_of)} sources have a test of their name or are named in one")
    if tested < TESTED:
        wrong.append("no test names: " + ", ".join(without))
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
