#!/usr/bin/env python3
"""How the page of a long program behaves in Chromium, which draws without a graphics card: its size, the seconds until its
first picture, the frames a second while it is turned.

usage: page_frames.py [--blocks N] [--plumbline PROGRAM] [--seconds S] [--page FILE]

Writes a program of N blocks (growth.py), compensates it with --report, and turns the path with the mouse for S seconds, once
alone and once with the machine. Prints Markdown. Processor time is of all processes of the browser, a frame. FILE: a page
that there is already. Needs what `scripts/setup --with-browser` installs.
"""
import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests/browser"), str(ROOT / "scripts")]

import browser  # noqa: E402

browser.need()

import growth  # noqa: E402

TURN = """
const [seconds, done] = arguments;
const canvas = document.querySelector(".scene canvas");
const box = canvas.getBoundingClientRect();
const mouse = (to, type, x) => to.dispatchEvent(new MouseEvent(type, {button: 0, buttons: 1, bubbles: true,
  clientX: x, clientY: box.top + 200}));
let frames = 0;
const begin = performance.now();
mouse(canvas, "mousedown", box.left + 300);
(function turn() {
  ++frames;
  mouse(document, "mousemove", box.left + 300 + 3 * frames);
  const passed = performance.now() - begin;
  if (passed < 1000 * seconds) requestAnimationFrame(turn);
  else { mouse(document, "mouseup", 0); done([frames, passed / 1000]); }
})();
"""


def processor_s(root):
    """Of a process and all that it started."""
    stat = {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            fields = (folder / "stat").read_text().rpartition(")")[2].split()
        except OSError:
            continue
        stat[int(folder.name)] = (int(fields[1]), (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK"))
    family = {root}
    while True:
        more = {pid for pid, (parent, _) in stat.items() if parent in family} | family
        if more == family:
            return sum(stat[pid][1] for pid in family if pid in stat)
        family = more


def whole(window):
    while window.run("return document.querySelector('.scene').dataset.drawn") != "whole":
        time.sleep(0.05)


def measure(page, seconds):
    with browser.Browser() as window:
        root = window.driver.service.process.pid
        window.driver.set_script_timeout(60 + seconds)
        window.shape(1400)
        first = window.open(page)
        begin = time.monotonic()
        whole(window)
        print(f"page of {Path(page).stat().st_size / 1e6:.1f} MB: first picture after {first:.2f} s, "
              f"all of it {time.monotonic() - begin:.1f} s later\n")
        print("| turned, 1400 px wide | frames a second | processor ms a frame |\n|---|---|---|")
        window.run("document.querySelector('.scene').scrollIntoView()")
        for name in ("path", "path and machine"):
            if name != "path":
                window.run("[...document.querySelectorAll('label')].find((of) => of.textContent === 'machine')"
                           ".querySelector('input').click()")
            whole(window)
            used = processor_s(root)
            frames, took = window.driver.execute_async_script(TURN, seconds)
            used = processor_s(root) - used
            print(f"| {name} | {frames / took:.0f} | {1000 * used / frames:.1f} |")
        for message in window.messages():
            print(message)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--blocks", type=int, default=1_000_000)
    parser.add_argument("--plumbline", default="build/release/plumbline")
    parser.add_argument("--seconds", type=float, default=3)
    parser.add_argument("--page")
    given = parser.parse_args()
    if given.page:
        measure(given.page, given.seconds)
        return
    with tempfile.TemporaryDirectory() as folder:
        growth.write_program(f"{folder}/long.ngc", given.blocks)
        subprocess.run([given.plumbline, "compensate", f"{folder}/long.ngc", *growth.MODEL, "-o", f"{folder}/out.ngc",
                        "--report", f"{folder}/page.html", "-q"], check=True)
        measure(f"{folder}/page.html", given.seconds)


if __name__ == "__main__":
    main()
