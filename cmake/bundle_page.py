#!/usr/bin/env python3
"""Puts the page that a report is read on together: template, style, modules and libraries, without the data.

usage: bundle_page.py --web DIR --d3 FILE --three FILE --orbit FILE --wide FILE... --licence NAME=FILE... --out DIR

Writes into DIR, in the order in which a page holds them: begin.html (up to the data), drawing.html (from the data to
the libraries that every page has), space.html (libraries of pages with a scene), end.html. The content policy names
the hash of each script and style, so that nothing else runs. The modules are put in the order of their imports; each
name at the top of one must be its own, since they share a scope.
"""
import argparse
import base64
import hashlib
import html
import re
import sys
from pathlib import Path

IMPORT = re.compile(r'^import \{[^}]*\} from "\./([\w.]+)";\n', re.MULTILINE)
EXPORT = re.compile(r"^export (?=(async )?(function|class|const|let)\b)", re.MULTILINE)
TOP = re.compile(r"^(?:export )?(?:async )?(?:function\*?|class|const|let) (\w+)", re.MULTILINE)
NAMES = re.compile(r'^import \{([^}]*)\} from "\./([\w.]+)";$', re.MULTILINE)


def ordered(folder, name, done, above=()):
    """The modules that `name` needs, then itself."""
    if name in above:
        raise SystemExit(f"{name}: modules import each other in a circle: {' -> '.join(above)}")
    if name in done:
        return
    text = (folder / name).read_text()
    for used in IMPORT.findall(text):
        ordered(folder, used, done, (*above, name))
    done[name] = text


def bundled(folder):
    done = {}
    ordered(folder, "page.mjs", done)
    owner = {}
    for name, text in done.items():
        for own in TOP.findall(text):
            if own in owner:
                raise SystemExit(f"{name}: {own} is in {owner[own]} as well; modules of the page share their names")
            owner[own] = name
        for names, of in NAMES.findall(text):
            for used in filter(None, (part.strip() for part in names.split(","))):
                if owner.get(used) != of:
                    raise SystemExit(f"{name}: {of} has no {used}")
        left = re.search(r"^(import|export)\b.*", EXPORT.sub("", IMPORT.sub("", text)), re.MULTILINE)
        if left:
            raise SystemExit(f"{name}: only `import {{ a, b }} from \"./module.mjs\";` and exports by name are "
                             f"understood: {left[0]}")
    body = "\n".join(EXPORT.sub("", IMPORT.sub("", text)) for text in done.values())
    return f'(() => {{\n"use strict";\n{body}}})();\n'


def script(path):
    text = path if isinstance(path, str) else path.read_text(encoding="utf-8")
    if re.search(r"</script|<!--", text, re.IGNORECASE):
        text = re.sub(r"<(?=/script|!--)", r"\\x3c", text, flags=re.IGNORECASE)
    return text


def digest(text):
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def main():
    parser = argparse.ArgumentParser()
    for name in ("web", "d3", "three", "orbit", "out"):
        parser.add_argument(f"--{name}", type=Path, required=True)
    parser.add_argument("--wide", type=Path, nargs="+", required=True)
    parser.add_argument("--licence", action="append", default=[])
    given = parser.parse_args()

    scripts = {"D3": script(given.d3), "THREE": script(given.three), "ORBIT": script(given.orbit),
               "WIDE": "\n".join(map(script, given.wide)),
               "MODULES": script(bundled(given.web / "modules"))}
    style = (given.web / "style.css").read_text()
    licences = "\n\n".join(f"{name}\n{'-' * len(name)}\n{Path(file).read_text(encoding='utf-8')}"
                           for name, file in (of.split("=", 1) for of in given.licence))
    policy = ("default-src 'none'; script-src " + " ".join(digest(text) for text in scripts.values()) +
              f"; style-src {digest(style)}; img-src data: blob:; base-uri 'none'; form-action 'none'")

    def filled(text):
        values = {**scripts, "STYLE": style, "POLICY": policy, "LICENCES": html.escape(licences, quote=False)}
        return re.sub(r"@(\w+)@", lambda at: values[at[1]], text)

    page = (given.web / "page.html").read_text()
    begin, rest = page.split("@DATA@\n")
    drawing, end = rest.split("@SPACE@\n")
    given.out.mkdir(parents=True, exist_ok=True)
    for name, text in {"begin": begin, "drawing": drawing, "end": end,
                       "space": (given.web / "space.html").read_text()}.items():
        (given.out / f"{name}.html").write_text(filled(text), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    sys.exit(main())
