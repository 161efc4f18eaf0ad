"""Times commands that read one file, each in turn, round by round, and prints them side by side.

time_commands.py [--rounds N] --input FILE "NAME : COMMAND : OUTPUT"...
Standard output goes to OUTPUT unless the command writes that file itself. Every figure is of the best round; ratios are
to the first command. Memory counts from about 14 MB: what this script itself holds when it starts a command."""

import argparse
import os
import pathlib
import subprocess
import sys
import time


def run(command, output):
    """Seconds and peak memory in MB of one run."""
    writes_itself = output in command
    with open(os.devnull if writes_itself else output, "wb") as standard_output:
        begin = time.perf_counter()
        process = subprocess.Popen(command, stdout=standard_output, stderr=subprocess.PIPE)
        complaint = process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - begin
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {process.returncode}\n{complaint.decode(errors='replace')}")
    return seconds, usage.ru_maxrss / 1024


def lines(path):
    with open(path, "rb") as file:
        return sum(1 for _ in file)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--input", required=True)
    parser.add_argument("commands", nargs="+")
    arguments = parser.parse_args()
    size, blocks = pathlib.Path(arguments.input).stat().st_size, lines(arguments.input)
    named = [[part.strip() for part in text.split(" : ")] for text in arguments.commands]

    best = {}
    for _ in range(arguments.rounds):
        for name, command, output in named:
            result = run(command.split(), output)
            best[name] = min(best.get(name, result), result)

    print(f"input: {arguments.input}, {blocks} lines, {size / 1e6:.2f} MB")
    print(f"{'':12}{'seconds':>10}{'MB in/s':>10}{'lines in/s':>13}{'lines out/s':>13}{'x slower':>10}{'peak MB':>9}")
    base = best[named[0][0]][0]
    for name, _, output in named:
        seconds, memory = best[name]
        print(f"{name:12}{seconds:10.4f}{size / 1e6 / seconds:10.1f}{blocks / seconds:13.0f}"
              f"{lines(output) / seconds:13.0f}{seconds / base:10.1f}{memory:9.1f}")


if __name__ == "__main__":
    main()
