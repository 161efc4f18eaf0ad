"""ns of one core a pose, of the exact correction with its limits and of a played pose, for each instruction set of this
processor; beside it how many times as fast as one lane.

pose_times.py [--program BENCH] [--min-time SECONDS]"""
import argparse
import json
import subprocess
import sys


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/release/exact_bench")
    parser.add_argument("--min-time", default="0.2")
    arguments = parser.parse_args()
    output = subprocess.run([arguments.program, f"--benchmark_min_time={arguments.min_time}", "--benchmark_format=json",
                             "--benchmark_repetitions=5"], capture_output=True, text=True, check=True).stdout
    best = {}
    for row in json.loads(output)["benchmarks"]:
        if row["run_type"] == "iteration":
            ns = 1e9 / row["items_per_second"]
            best[row["name"]] = min(ns, best.get(row["name"], ns))
    if not best:
        sys.exit(f"{arguments.program} measured nothing")
    print(f"{'':24}{'ns a pose':>12}{'times one lane':>17}")
    for name, ns in best.items():
        lane = best.get(name.split("/")[0] + "/one lane")
        ratio = f"{lane / ns:.2f}" if "/" in name and lane else ""
        print(f"{name:24}{ns:12.1f}{ratio:>17}")


if __name__ == "__main__":
    main()
