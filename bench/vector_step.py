"""What Python adds to a step of many environments: the time of envs.step() without that of the library.

    TASKC_HOME=build PYTHONPATH=python python3 bench/vector_step.py [ENVIRONMENTS] [SECONDS]

Decisions of crawling in `fast-tree` at random, on one thread; medians of all steps, in CPU time of that
thread, so that other load on the machine matters little.
"""

import sys
import time

import numpy as np

import taskc

COUNT = int(sys.argv[1]) if len(sys.argv) > 1 else 64
SECONDS = float(sys.argv[2]) if len(sys.argv) > 2 else 5.0


class Timed:
    """A function of the library, and how long its last call took [ns]."""

    def __init__(self, function):
        self.function = function
        self.took = 0

    def __call__(self, *arguments):
        start = time.thread_time_ns()
        status = self.function(*arguments)
        self.took = time.thread_time_ns() - start
        return status


envs = taskc.make_vec("crawling", num_envs=COUNT, threads=1)
timed = Timed(envs.sim._step)
envs.sim._step = timed
envs.reset(seed=1)
random = np.random.default_rng(1)
whole, added = [], []
end = time.perf_counter() + SECONDS
while time.perf_counter() < end:
    actions = random.uniform(-0.5, 0.5, envs.action_space.shape).astype(np.float32)
    start = time.thread_time_ns()
    envs.step(actions)
    took = time.thread_time_ns() - start
    whole.append(took)
    added.append(took - timed.took)

step = np.median(whole) / COUNT / 1000
python = np.median(added) / COUNT / 1000
print(f"{COUNT} environments, {len(whole)} steps: {step:.1f} us for each environment, "
      f"{python:.3f} us of it Python ({100 * python / step:.2f} %)")
