"""A folder of small programs: how many a second `plumbline batch` compensates, and how many it finds unchanged the second time.

scripts/bench runs it. Times are of the wall and of the processor; where others use the machine, too, the second says more."""
import argparse
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
SETTINGS = f"""plumbline = "settings 1"
model = "{ROOT / 'models/pm600-like.toml'}"
tolerance = "1um"
[work_offset]
G54 = [0, 0, -1008, 0, 0, 0]
"""


def program(number, blocks):
    """`blocks` blocks; other words for each number."""
    lines = [f"(PART {number})", "G21 G90 G94", "G0 X0 Y0 Z5 A0 B0 C0", "G1 Z0 F900"]
    lines += [f"G1 X{(number + 7 * i) % 50}.{number % 10} Y{i % 20} A{i % 5} B{number % 3} F2400" for i in range(blocks - 5)]
    return "\n".join([*lines, "M2", ""])


def make(folder, count, blocks, in_each):
    for i in range(count):
        path = folder / f"{i // in_each:03}/part-{i:06}.nc"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(program(i, blocks))
    (folder / "plumbline.toml").write_text(SETTINGS)


def measure(plumbline, folder, jobs):
    """Seconds of the wall and of the processor."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begin = time.perf_counter()
    done = subprocess.run([plumbline, "batch", "parts", "-o", "out", *(["--jobs", str(jobs)] if jobs else [])], cwd=folder,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    wall = time.perf_counter() - begin
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        sys.exit(done.stderr)
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stderr.strip(), after.ru_maxrss


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=ROOT / "build/release/plumbline", type=pathlib.Path, help="plumbline")
    parser.add_argument("--count", type=int, default=10_000, help="programs")
    parser.add_argument("--blocks", type=int, default=10, help="blocks of each")
    parser.add_argument("--in-each", type=int, default=1000, help="programs in a folder")
    parser.add_argument("--jobs", type=int, help="programs at a time (default: one for each processor)")
    parser.add_argument("--folder", help="where they are written (default: a new one, which goes again)")
    given = parser.parse_args()
    scratch = pathlib.Path(given.folder or tempfile.mkdtemp(prefix="plumbline-batch-")).resolve()
    try:
        shutil.rmtree(scratch / "parts", ignore_errors=True)
        shutil.rmtree(scratch / "out", ignore_errors=True)
        make(scratch / "parts", given.count, given.blocks, given.in_each)
        time.sleep(2.1)  # files that were written a moment ago are read again
        processors = len(os.sched_getaffinity(0))
        print(f"{given.count} programs of {given.blocks} blocks, {processors} processors")
        print(f"{'':12} {'s':>8} {'a second':>9} {'CPU s':>8} {'a CPU second':>13} {'MB':>6}")
        for name in ("first run", "unchanged"):
            wall, cpu, said, memory = measure(given.program.resolve(), scratch, given.jobs)
            print(f"{name:12} {wall:8.2f} {given.count / wall:9.0f} {cpu:8.2f} {given.count / cpu:13.0f} {memory / 1024:6.0f}   {said}")
    finally:
        if not given.folder:
            shutil.rmtree(scratch)


if __name__ == "__main__":
    main()
