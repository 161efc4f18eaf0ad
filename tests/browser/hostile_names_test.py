"""Names that would be markup, script or addresses, in programs, models, tools, datasets and file names: they stay text."""
import browser

browser.need()

import os
import shutil
import tempfile
import unittest
from pathlib import Path

import pages

PAYLOADS = [
    "<script>hacked()</script>", "</script><script>hacked()</script>", "<img src=x onerror=hacked()>",
    "<svg onload=hacked()>", "<svg><script>hacked()</script></svg>", "<body onload=hacked()>",
    "<iframe src=javascript:hacked()></iframe>", "<a href=javascript:hacked()>x</a>", "<!--<script>hacked()</script>",
    "<!--", "-->", "]]>", "<![CDATA[<script>hacked()</script>]]>", "\\u003cscript>hacked()</script>",
    "&lt;script&gt;hacked()&lt;/script&gt;", "<link rel=stylesheet href=http://evil.example/x.css>",
    "<meta http-equiv=refresh content='0;url=http://evil.example/'>", "<base href=http://evil.example/>",
    "<style>*{background:url(http://evil.example/x)}</style>", "<object data=http://evil.example/x></object>",
    "<math><mtext><script>hacked()</script></mtext></math>", "<details open ontoggle=hacked()>",
    "<template><script>hacked()</script></template>", "<noscript><p title='</noscript><img src=x onerror=hacked()>'>",
    "';hacked();//", "\\\"};hacked();//", "${hacked()}", "{{constructor.constructor('hacked()')()}}",
    "<textarea></textarea><script>hacked()</script>", "</title></style></textarea></pre><script>hacked()</script>",
]


def toml(text):
    return text.replace("\\", "\\\\").replace('"', '\\"')


def make(folder, payload):
    """A page whose program, model and file name hold the payload."""
    model = (pages.ROOT / "models/pm600-like.toml").read_text()
    name = next(line for line in model.splitlines() if line.startswith("name"))
    (folder / "model.toml").write_text(model.replace(name, f'name = "{toml(payload)}"', 1))
    comment = payload.replace("(", "[").replace(")", "]")
    # A comment of LinuxCNC ends at the first bracket; after a semicolon anything may stand.
    program = folder / (payload.replace("/", "_")[:60] + ".ngc")
    program.write_text(pages.PROGRAM.replace("(A FACE AND A CIRCLE)", f"({comment})")
                       .replace("N50 X40 F1500 A6", f"N50 X40 F1500 A6 ; {payload}"))
    pages.run(folder, "compensate", "./" + program.name, "-m", "model.toml", *pages.OFFSET, "-o", "out.nc",
              "--dialect", "linuxcnc", "--report", "page.html")
    return folder / "page.html"


def make_measured(folder, payload):
    """A page whose model, dataset, run, instrument and people hold the payload."""
    case, text = pages.CASE, toml(payload)
    model = (case / "base.toml").read_text()
    (folder / "base.toml").write_text(model.replace('name = "machine-s1"', f'name = "{text}"', 1))
    head, run, other = (case / "data/dataset.toml").read_text().split("[[run]]")[:3]
    protocol = "".join(f'{key} = "{text}"\n' for key in ("serial", "instrument", "operator", "date", "place", "remarks"))
    (folder / "dataset.toml").write_text(
        head.replace('"machine-s1"', f'"{text}"') + f"[protocol]\n{protocol}\n[[run]]"
        + run.replace('id = "01-p1-ccw"', f'id = "{text}"') + "[[run]]" + other)
    for table in ("01-p1-ccw.csv", "02-p1-cw.csv"):
        shutil.copy(case / "data" / table, folder)
    pages.run(folder, "circularity", "-d", "dataset.toml", "-m", "base.toml", "--report", "page.html")
    return folder / "page.html"


class HostileNames(unittest.TestCase):
    def test_of_programs_they_stay_text(self):
        for payload, window in self.pages_like_the_plain_one(make):
            self.assertTrue(window.run("return document.title").startswith(payload.replace("/", "_")[:20].strip()))
            self.assertIn(payload, window.run("return document.body.textContent"))

    def test_of_measurements_they_stay_text(self):
        for payload, window in self.pages_like_the_plain_one(make_measured):
            text = window.run("return document.getElementById('page').textContent")
            self.assertGreaterEqual(text.count(payload), 8, "run, machine, six of the protocol")

    def pages_like_the_plain_one(self, make):
        with browser.Browser() as window, tempfile.TemporaryDirectory() as top:
            window.shape(1000)
            plain = self.count(window, make_in(top, "plain", "harmless", make))
            for number, payload in enumerate(PAYLOADS):
                with self.subTest(payload=payload):
                    self.assertEqual(self.count(window, make_in(top, str(number), payload, make)), plain)
                    yield payload, window

    def count(self, window, page):
        """Elements of the page by name; nothing was run, nothing was asked for."""
        window.open(page)
        self.assertEqual(window.messages(), [])
        self.assertFalse(window.run("return 'hacked' in window"))
        asked = [url for url in window.requests() if not url.startswith(("file:", "data:", "blob:"))]
        self.assertEqual(asked, [])
        return window.run("""
            const counts = {};
            for (const node of document.querySelectorAll("*")) counts[node.tagName] = (counts[node.tagName] || 0) + 1;
            for (const tick of ["g", "line", "text"]) delete counts[tick];  // where names are long, axes are short
            return counts;""")


def make_in(top, name, payload, make):
    folder = Path(top) / name
    os.mkdir(folder)
    return make(folder, payload)


if __name__ == "__main__":
    unittest.main()
