"""What Python adds to a step of many environments: the time of envs.step() without that of the library.

    TASKC_HOME=build PYTHONPATH=python python3 bench/vector_step.py [ENVIRONMENTS] [STEPS]

Decisions of crawling in `fast-tree` at random, on one thread; medians of the steps in which no episode has
ended, and of those in which some have. By the wall: reading the clock of a thread's CPU time takes as long as
what is measured here, which is too short to be interrupted often.
"""

import sys
import time

import numpy as np

import taskc

COUNT = int(sys.argv[1]) if len(sys.argv) > 1 else 64
STEPS = int(sys.argv[2]) if len(sys.argv) > 2 else 300


class Timed:
    """A function of the library, and how long its last call took [ns]."""

    def __init__(self, function):
        self.function = function
        self.took = 0

    def __call__(self, *arguments):
        start = time.perf_counter_ns()
        status = self.function(*arguments)
        self.took = time.perf_counter_ns() - start
        return status


envs = taskc.make_vec("crawling", num_envs=COUNT, threads=1)
timed = Timed(envs.sim._step)
envs.sim._step = timed
envs.reset(seed=1)
random = np.random.default_rng(1)
whole, added = [], {False: [], True: []}
for _ in range(STEPS):
    actions = random.uniform(-0.5, 0.5, envs.action_space.shape).astype(np.float32)
    start = time.perf_counter_ns()
    envs.step(actions)
    took = time.perf_counter_ns() - start
    whole.append(took)
    added[envs.sim.ended.value > 0].append(took - timed.took)

print(f"{COUNT} environments: {np.median(whole) / COUNT / 1000:.1f} us for each environment and step")
for has_ended, times in added.items():
    if times:
        what = "some end" if has_ended else "none ends"
        print(f"Python in {len(times)} steps in which {what}: {np.median(times) / COUNT / 1000:.3f} us")
