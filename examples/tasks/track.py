#!/usr/bin/env python3
"""The motion of track.csv: knee bends, with the arms swung forward.

    python3 track.py ../../plugins/humanoid/robot.toml > track.csv

Each row has the angles of all joints and, by forward kinematics, the positions of all links. The
soles stay where they are in the robot's first pose, while the trunk leans forward. Its rotation and
its angular velocity are columns, too.
"""
import math
import sys
import tomllib

PERIOD = 2.0  # [s]
ROWS = 40  # to one period; the last row is the first one again
DEEPEST = math.radians(50)  # of the thighs
SWING = math.radians(70)  # of the arms
LEAN = math.radians(25)  # of the trunk


def bend(share):
    """How far the knees are bent at this share of the period: from 0 to 1."""
    return (1 - math.cos(2 * math.pi * share)) / 2


def angles(robot, bent):
    """The joints' angles [rad]."""
    anchor = {joint["name"]: joint["anchor"] for joint in robot["joints"]}
    pose = {joint["name"]: 0.0 for joint in robot["joints"]}
    for side in "left_", "right_":
        hip, knee, ankle = (anchor[side + name][2]
                            for name in ("hip_pitch", "knee_pitch", "ankle_pitch"))
        thigh = DEEPEST * bent
        shank = math.asin((hip - knee) / (knee - ankle) * math.sin(thigh))
        pose[side + "hip_pitch"] = thigh + LEAN * bent
        pose[side + "knee_pitch"] = -thigh - shank
        pose[side + "ankle_pitch"] = shank
        pose[side + "shoulder_pitch"] = SWING * bent
    return pose


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def turned(matrix, vector):
    return [sum(matrix[i][k] * vector[k] for k in range(3)) for i in range(3)]


def rotation(axis, angle):
    c, s = math.cos(angle), math.sin(angle)
    return {"x": [[1, 0, 0], [0, c, -s], [0, s, c]],
            "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
            "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis]


def positions(robot, pose, lean):
    """The links' positions [m], relative to the first one, the trunk."""
    first = robot["links"][0]["name"]
    frames = {first: (rotation("y", lean), [0.0, 0.0, 0.0])}
    for joint in robot["joints"]:  # each after its parent's
        matrix, offset = frames[joint["parent"]]
        anchor = joint["anchor"]
        turn = rotation(joint["axis"], -pose[joint["name"]])
        moved = turned(turn, anchor)
        step = turned(matrix, [anchor[i] - moved[i] for i in range(3)])
        frames[joint["child"]] = times(matrix, turn), [offset[i] + step[i] for i in range(3)]
    places = {}
    for link in robot["links"]:
        matrix, offset = frames[link["name"]]
        place = turned(matrix, link["position"])
        places[link["name"]] = [offset[i] + place[i] for i in range(3)]
    return places


def main():
    with open(sys.argv[1], "rb") as file:
        robot = tomllib.load(file)
    first = robot["poses"][0]
    sole = positions(robot, angles(robot, 0), 0)["left_foot"]
    names = [joint["name"] + " [deg]" for joint in robot["joints"]]
    names += [f"{link['name']}.{axis} [m]" for link in robot["links"] for axis in "xyz"]
    names += ["turn.w", "turn.x", "turn.y", "turn.z"]
    names += [f"spin.{axis} [deg/s]" for axis in "xyz"]
    print(", ".join(["time [s]"] + names))
    for row in range(ROWS + 1):
        share = row % ROWS / ROWS
        lean = LEAN * bend(share)
        pose = angles(robot, bend(share))
        places = positions(robot, pose, lean)
        lift = [first["position"][i] + sole[i] - places["left_foot"][i] for i in range(3)]
        numbers = [round(math.degrees(pose[joint["name"]]), 4) for joint in robot["joints"]]
        numbers += [round(places[link["name"]][i] + lift[i], 6)
                    for link in robot["links"] for i in range(3)]
        numbers += [round(part, 6) for part in (math.cos(lean / 2), 0, math.sin(lean / 2), 0)]
        speed = LEAN * math.pi / PERIOD * math.sin(2 * math.pi * share)
        numbers += [0, round(math.degrees(speed), 4), 0]
        print(", ".join(f"{number + 0:.6g}" for number in [row * PERIOD / ROWS] + numbers))


main()
