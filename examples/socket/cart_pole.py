"""A cart with a pole on it, for `trainer train cart_pole.task --environment-socket PATH`.

Without libraries, and with JSON alone: docs/environments.md has the messages."""
import json
import math
import os
import random
import socket
import sys

TIME_STEP = 0.02  # s
GRAVITY, CART, POLE, HALF_LENGTH = 9.8, 1.0, 0.1, 0.5  # m/s^2, kg, kg, m

GREETING = {
    "taskc_environment": 1,
    "time_step": TIME_STEP,
    "action": {"low": [-10.0], "high": [10.0]},  # N
    "sensors": [
        {"name": "cart.position", "type": "real", "unit": "m"},
        {"name": "cart.velocity", "type": "real", "unit": "m/s"},
        {"name": "pole.angle", "type": "real", "unit": "rad"},
        {"name": "pole.velocity", "type": "real", "unit": "rad/s"},
    ],
}


def step(state, force):
    x, speed, angle, rate = state
    sine, cosine, mass = math.sin(angle), math.cos(angle), CART + POLE
    push = (force + POLE * HALF_LENGTH * rate * rate * sine) / mass
    turn = (GRAVITY * sine - cosine * push) / (
        HALF_LENGTH * (4 / 3 - POLE * cosine ** 2 / mass))
    gain = push - POLE * HALF_LENGTH * turn * cosine / mass
    return [x + TIME_STEP * speed, speed + TIME_STEP * gain,
            angle + TIME_STEP * rate, rate + TIME_STEP * turn]


def serve(stream):
    stream.write(json.dumps(GREETING) + "\n")
    stream.flush()
    for line in stream:
        request = json.loads(line)
        if "reset" in request:
            draw = random.Random(request["reset"]["seed"])  # the same seed, the same episode
            state = [draw.uniform(-0.05, 0.05) for _ in range(4)]
        else:
            state = step(state, request["step"][0])
        stream.write(json.dumps({"sensors": state}) + "\n")
        stream.flush()


listener = socket.socket(socket.AF_UNIX)
if os.path.exists(sys.argv[1]):
    os.remove(sys.argv[1])
listener.bind(sys.argv[1])
listener.listen()
while True:  # one trainer after the other
    with listener.accept()[0] as connection, connection.makefile("rw") as stream:
        serve(stream)
