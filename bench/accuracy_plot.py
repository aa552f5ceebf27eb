#!/usr/bin/env python3
"""Draws what accuracy costs in our solver and in another engine, as an SVG.

    build/bin/profile_ensemble ROBOT RUNS paper-tree@0.1 fast-tree@5 ... mujoco@5 ... > ROBOT.md
    bench/accuracy_plot.py ROBOT.md... > docs/images/accuracy.svg

The first row of a table is the reference. The error on the ground is the root mean square of how far,
in relation to it, contact points, links in contact and the joints' speed are from it on average.
"""
import math
import sys

ENGINES = {"fast-tree": ("tree solver", "#1f6fb2"), "mujoco": ("MuJoCo", "#c2571a")}
WIDTH, HEIGHT, LEFT, TOP = 225, 165, 74, 44
GAP_X, GAP_Y = 28, 34
COST = (5, 250)  # milliseconds of CPU time for a second of the robot's
AIR = (0.01, 1)  # degrees
GROUND = (0.5, 60)  # per cent


def read_table(path):
    """The robot's name, and for each profile its means."""
    with open(path, encoding="utf-8") as file:
        rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in file]
    means = {row[0]: [float(cell.split()[0]) for cell in row[1:]] for row in rows[2:]}
    return rows[0][0].split(",")[0], means


def curves(means):
    """For each engine its points (cost, error in the air, error on the ground), by their cost."""
    reference = next(iter(means.values()))
    points = {engine: [] for engine in ENGINES}
    for name, row in list(means.items())[1:]:
        ground = [row[i] / reference[i] - 1 for i in (2, 3, 4)]
        points[name.partition("@")[0]].append(
            (1000 / row[7], math.degrees(row[6]),
             100 * math.sqrt(sum(e * e for e in ground) / len(ground))))
    return {engine: sorted(row) for engine, row in points.items()}


def place(value, limits, start, length):
    low, high = (math.log(limit) for limit in limits)
    return start + length * (math.log(min(max(value, limits[0]), limits[1])) - low) / (high - low)


def text(x, y, content, anchor="middle", size=11, color="#444", more=""):
    return (f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}" '
            f'fill="{color}"{more}>{content}</text>')


def panel(x, y, engines, column, limits, ticks, unit, is_first, is_last):
    lines = [f'<rect x="{x}" y="{y}" width="{WIDTH}" height="{HEIGHT}" fill="none" stroke="#bbb"/>']
    for tick in ticks:
        at = place(tick, limits, y + HEIGHT, -HEIGHT)
        lines.append(f'<path d="M{x} {at:.1f}h{WIDTH}" stroke="#e6e6e6"/>')
        if is_first:
            lines.append(text(x - 6, at + 4, f"{tick:g} {unit}", "end"))
    for tick in (10, 20, 50, 100, 200):
        at = place(tick, COST, x, WIDTH)
        lines.append(f'<path d="M{at:.1f} {y}v{HEIGHT}" stroke="#e6e6e6"/>')
        if is_last:
            lines.append(text(at, y + HEIGHT + 15, f"{tick}"))
    for engine, points in engines.items():
        color = ENGINES[engine][1]
        spots = [(place(point[0], COST, x, WIDTH), place(point[column], limits, y + HEIGHT, -HEIGHT))
                 for point in points]
        path = " ".join(f"{a:.1f},{b:.1f}" for a, b in spots)
        lines.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="2"/>')
        lines += [f'<circle cx="{a:.1f}" cy="{b:.1f}" r="3.5" fill="{color}"/>' for a, b in spots]
    return lines


def draw(tables):
    width = LEFT + len(tables) * (WIDTH + GAP_X)
    height = TOP + 2 * HEIGHT + GAP_Y + 48
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
             f'width="{width}" height="{height}" font-family="sans-serif">',
             f'<rect width="{width}" height="{height}" fill="white"/>']
    x = width - GAP_X
    for name, color in reversed(ENGINES.values()):
        lines.append(text(x, 16, name, "end", 12, color, ' font-weight="bold"'))
        x -= 9 * len(name) + 4
    for i, (robot, means) in enumerate(tables):
        x = LEFT + i * (WIDTH + GAP_X)
        below = TOP + HEIGHT + GAP_Y
        engines = curves(means)
        lines.append(text(x, TOP - 10, robot, "start", 13, "#111"))
        lines += panel(x, TOP, engines, 1, AIR, (0.02, 0.05, 0.1, 0.2, 0.5), "°", i == 0, False)
        lines += panel(x, below, engines, 2, GROUND, (1, 2, 5, 10, 20, 50), "%", i == 0, True)
    for y, label in ((TOP, "joint angles, in the air"), (TOP + HEIGHT + GAP_Y, "contacts, on the ground")):
        lines.append(text(14, y + HEIGHT / 2, label, more=f' transform="rotate(-90 14 {y + HEIGHT / 2})"'))
    lines.append(text(LEFT + (width - LEFT - GAP_X) / 2, height - 10,
                      "CPU time for a second of the robot's [ms]"))
    return "\n".join(lines + ["</svg>"])


if __name__ == "__main__":
    print(draw([read_table(path) for path in sys.argv[1:]]))
