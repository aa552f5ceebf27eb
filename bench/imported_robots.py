#!/usr/bin/env python3
"""Imports robots of other programs, holds them still, lets them learn to move, and prints a row for each:
the table of docs/robots.md.

    bench/imported_robots.py [--seconds 120] NAME=FILE.urdf NAME=FILE.xml ...

Each learns by `motion_search`, without a word about it: all joints, the start pose that the import has
proposed, paid for the way ahead that the base makes in ten seconds. What falls is not stopped, so that
crawling counts. Robots with a fixed base have nothing to learn here.
"""

import argparse
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

TASK = """task move for {name}

start standing

metric distance = base.position.x
metric max speed = norm(base.velocity)

on end_of_time_step {{
  reward rate ahead = base.velocity.x / 1 m
  if time > 10 s {{ truncate_episode "time is up" }}
}}
"""

BIN = pathlib.Path(__file__).resolve().parents[1] / "build" / "bin"


def run(*arguments):
    return subprocess.run([str(a) for a in arguments], capture_output=True, text=True)


def error_of(result):
    lines = [line for line in result.stderr.splitlines() if "error:" in line]
    return (lines or result.stderr.splitlines() or ["?"])[0]


def hold(trainer, robot):
    """What becomes of the first pose when it is held for a second."""
    report = json.loads(run(trainer, "robot", "show", robot, "--profile", "fast-tree", "--json").stdout)
    pose = report["poses"][0]
    if report["fixed_base"]:
        standing = "fixed base"
    elif pose["diverged"]:
        standing = "diverges"
    else:
        standing = "stands" if pose["stands"] else f"falls by {pose['tilt'] * 57.3:.0f}°"
    return report, f"{standing}, {pose['chatter']:.2g} rad/s"


def learn(trainer, robots, name, seconds, folder):
    """The best motion after so many seconds of CPU time: how far it went, or why there is none."""
    task = folder / "move.task"
    task.write_text(TASK.format(name=name))
    out = folder / "run"
    training = subprocess.Popen(
        [trainer, "train", task, "--robots", robots, "--agent", "motion_search", "--profile", "fast-tree",
         "--seed", "1", "--episodes", "1000000", "--record-every", "0", "--jobs", "1", "--out", out, "--json"],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    episodes = []
    complaint = "nothing"
    spent = 0
    for line in training.stdout:
        if not line.startswith("{"):
            complaint = line.strip()
            continue
        episode = json.loads(line)
        if "return" not in episode:
            continue
        episodes.append(episode)
        spent += episode["cpu_seconds"]
        if spent > seconds:
            training.send_signal(signal.SIGINT)
            break
    training.communicate()
    sound = [episode for episode in episodes if episode["end"]["kind"] != "diverged"]
    if not sound:
        return f"all {len(episodes)} episodes diverge" if episodes else complaint
    best = max(sound, key=lambda episode: episode["return"])
    return f"{best['metrics']['distance']:.1f} m in 10 s, {len(episodes)} episodes"


def row(trainer, name, file, seconds):
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        robots = folder / "robots"
        imported = run(trainer, "robot", "import", file, "--name", name, "--robots", robots, "--json")
        if imported.returncode != 0:
            return f"| `{name}` | | | {error_of(imported)} | | |"
        answer = json.loads(imported.stdout)
        report, standing = hold(trainer, answer["file"])
        size = f"{len(report['links'])}, {len(report['joints'])}"
        moved = "" if report["fixed_base"] else learn(trainer, robots, answer["name"], seconds, folder)
        warnings = len(answer["warnings"])
        return f"| `{name}` | {size} | {report['mass']:.3g} kg | {warnings} | {standing} | {moved} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=120, help="how long each may learn: CPU time")
    parser.add_argument("--trainer", default=BIN / "trainer", help="the program to try")
    parser.add_argument("robots", nargs="+", metavar="NAME=FILE")
    options = parser.parse_args()
    print("| robot | links, joints | mass | warnings | held for a second | learned |")
    print("|---|---|---|---|---|---|")
    for robot in options.robots:
        name, equals, file = robot.partition("=")
        if not equals or not re.fullmatch(r"[A-Za-z_]\w*", name):
            sys.exit(f"{robot}: write NAME=FILE, with a name of letters, digits and underscores")
        print(row(str(options.trainer), name, file, options.seconds), flush=True)


if __name__ == "__main__":
    main()
