#!/usr/bin/env python3
"""What a folder of many runs costs: makes a study of tiny ones, trains it, looks at it in all the ways
that there are, and prints seconds, memory and sizes: the table of docs/scale.md.

    bench/many_runs.py [--runs 10000] [--folder DIR] [--jobs 2]

Four experiments with cheap robots and three episodes a run. Started again with the same folder, it goes on
where it was stopped; what is there already is not trained again.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]

STUDY = """profile = "fast-tree"
episodes = 3
record_every = 1
seeds = "1..{seeds}"

[[experiments]]
name = "cart_pole"
task = "{tasks}/swing_up.task"

[[experiments]]
name = "cart_pole_search"
task = "{tasks}/swing_up.task"
agent = "motion_search"

[[experiments]]
name = "planar_hopper"
task = "{tasks}/hop.task"

[[experiments]]
name = "rover"
task = "{tasks}/drive.task"
"""


def measured(what, words):
    """Runs a program, and prints its seconds and the most memory that it, or one that it started, had."""
    start = time.monotonic()
    process = subprocess.Popen([str(word) for word in words], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{what}: ended with {status}")
    print(f"| {what} | {time.monotonic() - start:.1f} s | {usage.ru_utime + usage.ru_stime:.1f} s | "
          f"{usage.ru_maxrss / 1024:.0f} MB |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=10_000)
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "many_runs")
    parser.add_argument("--trainer", type=pathlib.Path, default=ROOT / "build" / "bin" / "trainer")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    study = options.folder / "study.toml"
    study.write_text(STUDY.format(seeds=options.runs // 4, tasks=ROOT / "examples" / "tasks"))
    runs = options.folder / "runs"
    page = options.folder / "report.html"
    train = [options.trainer, "study", study, "--out", runs, "--jobs", options.jobs, "--quiet"]
    print("| | takes | CPU time | memory |\n|---|---|---|---|")
    measured("`study`: all made and trained", train)
    measured("`study` again: all are there", train)
    measured("`study status`", [options.trainer, "study", "status", runs])
    measured("`show`", [options.trainer, "show", runs])
    measured("`report`", [options.trainer, "report", runs, "-o", page])
    measured("`report --json`", [options.trainer, "report", runs, "--json"])
    measured("`export --csv`", [options.trainer, "export", runs, "--csv", options.folder / "all.csv"])
    files = [file for file in runs.rglob("*") if file.is_file()]
    size = sum(file.stat().st_size for file in files)
    print(f"\n{len(files)} files of {size / 1e6:.0f} MB for {options.runs} runs; the report has "
          f"{page.stat().st_size / 1e6:.1f} MB, the table {(options.folder / 'all.csv').stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
