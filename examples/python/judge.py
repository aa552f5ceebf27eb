"""Records what a cart does, lets a task judge it, and draws what it was paid.

    python3 examples/python/judge.py [PICTURE.png]

Needs NumPy and an installed taskc, or PYTHONPATH=python and TASKC_HOME=build in this folder's project;
the picture needs matplotlib.
"""

import sys
import tempfile
from pathlib import Path

import numpy as np

import taskc

TIME_STEP = 0.02  # [s]
TASK = Path(__file__).parent.parent / "embed_cpp" / "docking.task"

# %% What the task reads, and what may be changed in it

task = taskc.load(TASK)
print(task.doc)
for sensor in task.sensors.values():
    print(f"  reads {sensor.name}: {sensor.type} [{sensor.unit}], an array {('time',) + sensor.shape}")
for param in task.params.values():
    print(f"  param {param.name} = {param.initial} {param.unit} in {param.minimum} .. {param.maximum}")


# %% A cart that is pulled to its dock by a spring and a damper


def drive(damping, steps=1000):
    """The sensors of an episode, as arrays [time, 2]."""
    position, velocity = np.array([1.0, -1.0]), np.zeros(2)
    positions, velocities = np.zeros((steps, 2)), np.zeros((steps, 2))
    for step in range(steps):
        velocity = velocity + (-2 * position - damping * velocity) * TIME_STEP
        position = position + velocity * TIME_STEP
        positions[step], velocities[step] = position, velocity
    return {"cart.position": positions, "cart.velocity": velocities}


# %% Judged: all episodes at once, in as many threads as there are processors

dampings = [0.2, 1, 3]
results = task.evaluate([drive(damping) for damping in dampings], time_step=TIME_STEP,
                        params={"reach": 1}, with_term_sums=True)
for damping, result in zip(dampings, results):
    end = result.reason or "not over"
    print(f"damping {damping}: return {result.episode_return:.3f}, {end} after "
          f"{result.time_steps * TIME_STEP:.1f} s; "
          + ", ".join(f"{name} {paid:.2f}" for name, paid in result.terms.items()))

# %% A mistake in a task is data, too

with tempfile.TemporaryDirectory() as folder:
    mistaken = Path(folder) / "mistaken.task"
    mistaken.write_text("task mistaken\nsensor speed: real [m/s]\n"
                        "on end_of_time_step { reward rate fast = sped / 1 m/s }\n")
    try:
        taskc.load(mistaken)
    except taskc.TaskError as error:
        mistake = error.diagnostics[0]
        print(f"line {mistake.line}: {mistake.message}; write `{mistake.fixes[0].text}`")

# %% What each term has paid so far, over time

try:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
except ImportError:
    sys.exit(0)
figure, axes = pyplot.subplots(1, len(results), sharey=True, figsize=(9, 3), layout="constrained")
for damping, result, axis in zip(dampings, results, axes):
    times = np.arange(1, result.time_steps + 1) * TIME_STEP
    for column, term in enumerate(task.terms):
        axis.plot(times, result.term_sums[:result.time_steps, column], label=term.name)
    axis.set_title(f"damping {damping}")
    axis.set_xlabel("time [s]")
axes[0].set_ylabel("paid so far")
axes[0].legend()
picture = sys.argv[1] if len(sys.argv) > 1 else "judge.png"
figure.savefig(picture, dpi=100)
print(f"wrote {picture}")
