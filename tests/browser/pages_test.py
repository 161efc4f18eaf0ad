"""Every page in a browser: two widths, light and dark, by mouse and by keyboard, printed."""
import browser

browser.need()

import re
import tempfile
import unittest
from pathlib import Path

import pages

# Those of readings carry figures of ISO 230-4, torque profiles and a table for each run.
SHEETS = {"compare": 6, "diagnose": 6, "identify": 8, "calibrate": 8}
SHAPES = [(1400, "light"), (1400, "dark"), (400, "light"), (400, "dark")]


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.made = {}
        for name, (make, scene, drawings) in pages.PAGES.items():
            here = Path(cls.folder.name) / name
            here.mkdir()
            cls.made[name] = (make(here), scene, drawings)
        cls.browser = browser.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.driver.quit()
        cls.folder.cleanup()

    def test_in_every_shape(self):
        for name, (page, scene, drawings) in self.made.items():
            for width, theme in SHAPES:
                with self.subTest(page=name, width=width, theme=theme):
                    self.browser.shape(width, theme=theme)
                    self.browser.open(page)
                    self.check_drawn(scene, drawings, width, theme)
                    self.assertEqual(self.browser.run(NAMELESS), [])
                    self.assertEqual(self.browser.run(CONTRAST), [])
                    if scene:
                        self.check_choosing()
                        self.check_sliders()
                    self.assertEqual(self.browser.messages(), [])

    def check_drawn(self, scene, drawings, width, theme):
        asked = [url for url in self.browser.requests() if not url.startswith(("file:", "data:", "blob:"))]
        self.assertEqual(asked, [])
        self.assertGreaterEqual(len(self.browser.find("main svg")), drawings)
        self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), width)
        ground = self.browser.run("return getComputedStyle(document.body).backgroundColor")
        self.assertEqual(ground, "rgb(255, 255, 255)" if theme == "light" else "rgb(20, 23, 27)")
        self.assertEqual(len(self.browser.find("main canvas")), 1 if scene else 0)
        if scene:
            self.assertGreater(self.browser.run(PAINTED), 300)

    def text(self, selector):
        return self.browser.run("return document.querySelector(arguments[0]).textContent", selector)

    def picture(self):
        """Of what is in space, all of it, as for print."""
        self.browser.run("window.dispatchEvent(new Event('beforeprint'))")
        return self.browser.run("return document.querySelector('.scene canvas').toDataURL()")

    def check_choosing(self):
        """By keyboard, by a click on a curve, on the path and on a link of the worst places."""
        from selenium.webdriver.common.keys import Keys
        box = self.browser.find(".scene")[0]
        self.browser.press(box, Keys.HOME)
        first = self.text(".point")
        self.browser.press(box, Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
        self.assertNotEqual(self.text(".point"), first)
        self.browser.press(box, Keys.END)
        last = self.text(".point")
        self.browser.run(CLICK_CURVE)
        self.assertNotEqual(self.text(".point"), last)
        self.browser.press(box, Keys.END)
        self.browser.run(CLICK_PATH, last)
        self.assertNotEqual(self.text(".point"), last)
        link = self.browser.find("button.link")[0]
        self.browser.run("arguments[0].click()", link)
        self.assertIn(self.browser.run("return arguments[0].closest('tr').children[2].textContent", link),
                      self.text(".point"))

    def check_sliders(self):
        """Each moves something in the picture."""
        self.browser.run("for (const tick of document.querySelectorAll('input[type=checkbox]')) "
                         "if (!tick.checked) tick.click()")
        for slider in self.browser.find("input[type=range]"):
            before = self.picture()
            self.browser.run("""
                const input = arguments[0];
                input.value = Number(input.value) < (Number(input.min) + Number(input.max)) / 2 ? input.max : input.min;
                input.dispatchEvent(new Event("input", {bubbles: true}));""", slider)
            self.assertNotEqual(self.picture(), before)

    def test_a_long_program_is_drawn_coarse_while_it_turns_and_whole_at_rest(self):
        self.browser.shape(1400)
        self.browser.open(pages.long_program(Path(self.folder.name)))
        self.browser.run_async(WHOLE)
        in_parts = self.browser.run("return document.querySelector('.scene canvas').toDataURL()")
        whole = self.picture()
        self.assertLess(self.browser.run_async(DIFFERING.replace("OTHER", in_parts)), 0.005)
        self.browser.run("document.querySelector('.scene').scrollIntoView()")
        turning = self.browser.run_async(TURN)
        self.assertEqual(turning, "quick")
        self.assertGreater(self.browser.run(PAINTED), 300)
        self.assertNotEqual(self.picture(), whole)
        self.assertEqual(self.browser.messages(), [])

    def test_prints(self):
        for name, (page, _, _) in self.made.items():
            with self.subTest(page=name):
                self.browser.shape(1400)
                self.browser.open(page)
                pdf = self.browser.print_pdf()
                self.assertTrue(pdf.startswith(b"%PDF"))
                self.assertGreater(len(pdf), 20000)
                sheets = len(re.findall(rb"/Type\s*/Page\b", pdf))
                self.assertLessEqual(sheets, SHEETS.get(name, 4))
                self.assertRegex(re.search(rb"/MediaBox\s*\[[^]]*\]", pdf)[0], rb" 59[45]")  # points: the width of A4


WHOLE = """
const done = arguments[0];
(function look() {
  if (document.querySelector(".scene").dataset.drawn === "whole") done(); else setTimeout(look, 20);
})();
"""

# The share of the pixels that are not those of another picture.
DIFFERING = """
const done = arguments[0];
const bytesOf = (from) => {
  const to = document.createElement("canvas");
  to.width = from.width; to.height = from.height;
  const context = to.getContext("2d");
  context.drawImage(from, 0, 0);
  return context.getImageData(0, 0, to.width, to.height).data;
};
const here = bytesOf(document.querySelector(".scene canvas"));
const other = new Image();
other.onload = () => {
  const there = bytesOf(other);
  let differing = 0;
  for (let i = 0; i < here.length; i += 4)
    differing += [0, 1, 2, 3].some((of) => Math.abs(here[i + of] - there[i + of]) > 24);
  done(differing / (here.length / 4));
};
other.src = "OTHER";
"""

# Drags the path with the mouse; how it is drawn before the mouse is let go.
TURN = """
const done = arguments[0];
const canvas = document.querySelector(".scene canvas");
const box = canvas.getBoundingClientRect();
const mouse = (to, type, x) => to.dispatchEvent(new MouseEvent(type, {button: 0, buttons: 1, bubbles: true,
  clientX: box.left + x, clientY: box.top + 200}));
mouse(canvas, "mousedown", 300);
let step = 0;
(function turn() {
  mouse(document, "mousemove", 300 + 20 * ++step);
  if (step < 8) { requestAnimationFrame(turn); return; }
  const drawn = document.querySelector(".scene").dataset.drawn;
  mouse(document, "mouseup", 0);
  done(drawn);
})();
"""

# Pixels of the scene that hold something.
PAINTED = """
const from = document.querySelector(".scene canvas");
const to = document.createElement("canvas");
to.width = from.width; to.height = from.height;
const context = to.getContext("2d");
context.drawImage(from, 0, 0);
const bytes = context.getImageData(0, 0, to.width, to.height).data;
let painted = 0;
for (let i = 3; i < bytes.length; i += 4) painted += bytes[i] > 0;
return painted;
"""

# At the left end of the first curve along the program.
CLICK_CURVE = """
const svg = document.querySelector(".panels svg[role=img]");
svg.scrollIntoView({block: "center"});
const box = svg.getBoundingClientRect();
svg.dispatchEvent(new MouseEvent("click", {clientX: box.left + 63, clientY: box.top + 60, bubbles: true}));
"""

# Over the scene, until another point is chosen.
CLICK_PATH = """
const canvas = document.querySelector(".scene canvas");
const box = canvas.getBoundingClientRect();
for (let y = 4; y < box.height; y += 8) for (let x = 4; x < box.width; x += 8) {
  const at = {clientX: box.left + x, clientY: box.top + y, bubbles: true};
  canvas.dispatchEvent(new PointerEvent("pointerdown", at));
  canvas.dispatchEvent(new PointerEvent("pointerup", at));
  if (document.querySelector(".point").textContent !== arguments[0]) return;
}
"""

# Drawings and controls that a screen reader could not tell.
NAMELESS = """
const named = (node) => (node.getAttribute("aria-label") || node.textContent || "").trim() !== "";
return [...document.querySelectorAll("svg[role=img], .scene, button, select, input")]
  .filter((node) => !named(node) && !(node.closest("label") && named(node.closest("label"))))
  .map((node) => node.outerHTML.slice(0, 80));
"""

# Contrast of text with what it stands on: WCAG 2.1, 1.4.3: at least 4.5, of large text 3.
CONTRAST = """
const channel = (of) => { const share = of / 255; return share <= 0.03928 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4; };
const light = ([r, g, b]) => 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b);
const numbers = (colour) => colour.match(/[\\d.]+/g).map(Number);
const cells = new Map();
const cellsOf = (svg) => {
  if (!cells.has(svg)) cells.set(svg, [...svg.querySelectorAll("rect")].map((rect) => [rect.getBoundingClientRect(), getComputedStyle(rect).fill]));
  return cells.get(svg);
};
// A number in a cell of a map stands on the cell.
const cellUnder = (node) => {
  const box = node.getBoundingClientRect();
  const [x, y] = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
  return cellsOf(node.ownerSVGElement).find(([of, fill]) => fill !== "none" && of.left <= x && x <= of.right && of.top <= y && y <= of.bottom);
};
const ground = (node) => {
  if (node instanceof SVGElement && cellUnder(node)) return numbers(cellUnder(node)[1]);
  for (let at = node; at; at = at.parentElement) {
    const of = numbers(getComputedStyle(at).backgroundColor);
    if (of.length < 4 || of[3] > 0.99) return of;
  }
  return [255, 255, 255];
};
const faint = new Set();
for (const node of document.querySelectorAll("main *")) {
  if (node.tagName === "title") continue;
  if (![...node.childNodes].some((child) => child.nodeType === 3 && child.textContent.trim())) continue;
  const style = getComputedStyle(node);
  const of = node instanceof SVGElement ? style.fill : style.color;
  if (of === "none") continue;
  const [a, b] = [light(numbers(of)), light(ground(node))].sort((x, y) => y - x);
  const least = parseFloat(style.fontSize) >= 24 ? 3 : 4.5;
  if ((a + 0.05) / (b + 0.05) < least) faint.add(node.tagName + "." + node.getAttribute("class") + ": " + node.textContent.slice(0, 30));
}
return [...faint];
"""

if __name__ == "__main__":
    unittest.main()
