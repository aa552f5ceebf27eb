"""Searches for a way to crawl: a periodic motion, by the cross-entropy method, in many environments at once.

    python3 examples/python/crawl.py [GENERATIONS [PICTURE.png]]

Needs NumPy and an installed taskc, or PYTHONPATH=python and TASKC_HOME=build in this folder's project;
the picture needs matplotlib. Each generation draws motions from a normal distribution, which the best of
them then say anew (R. Y. Rubinstein, "The cross-entropy method for combinatorial and continuous
optimization", 1999).
"""

import sys

import numpy as np

import taskc

GENERATIONS = int(sys.argv[1]) if len(sys.argv) > 1 else 15
MOTIONS, BEST = 32, 8
FREQUENCY = 1.5  # [Hz]

# %% The environments: one for each motion of a generation

envs = taskc.make_vec("crawling", num_envs=MOTIONS)
print(f"{envs.num_envs} x {envs.sim.robot} in `{envs.sim.profile}` on {envs.sim.threads} threads; "
      f"a decision lasts {envs.dt} s and moves {envs.single_action_space.shape[0]} coordinates")
for each in envs.observed:
    print(f"  observed from {each.offset}: {each.name} [{each.unit}], {each.type}")


def actions_at(time, motions):
    """motions: [motion, 3, coordinate]: where each coordinate is in the middle, and two amplitudes."""
    phase = 2 * np.pi * FREQUENCY * time
    return (motions[:, 0] + np.sin(phase) * motions[:, 1] + np.cos(phase) * motions[:, 2]).astype(
        np.float32)


def run(motions):
    """An episode for each motion: its return, and that of each reward term."""
    envs.reset(seed=1)
    is_over = np.zeros(len(motions), bool)
    returns = np.zeros(len(motions))
    terms = {name: np.zeros(len(motions)) for name in envs.sim.term_names}
    step = 0
    while not is_over.all():
        _, _, terminated, truncated, infos = envs.step(actions_at(step * envs.dt, motions))
        step += 1
        ends = (terminated | truncated) & ~is_over  # who is over goes on with another episode
        is_over |= ends
        if ends.any():
            returns[ends] = infos["task"]["return"][ends]
            for name, paid in terms.items():
                paid[ends] = infos["task"]["terms"][name][ends]
    return returns, terms


# %% The search

random = np.random.default_rng(1)
shape = (3, envs.single_action_space.shape[0])
mean, deviation = np.zeros(shape), np.full(shape, 0.4)
history = []
for generation in range(GENERATIONS):
    motions = mean + deviation * random.standard_normal((MOTIONS,) + shape)
    returns, terms = run(motions)
    best = motions[np.argsort(returns)[-BEST:]]
    mean, deviation = best.mean(axis=0), best.std(axis=0) + 0.02
    history.append({name: paid.mean() for name, paid in terms.items()})
    print(f"generation {generation}: mean return {returns.mean():.2f}, best {returns.max():.2f}; "
          + ", ".join(f"{name} {paid:.2f}" for name, paid in history[-1].items()))

# %% What it came to, and what it looks like

try:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
except ImportError:
    sys.exit(0)
env = taskc.make("crawling", render_mode="rgb_array")
env.reset(seed=1)
for step in range(60):
    *_, terminated, truncated, _ = env.step(actions_at(step * env.dt, mean[None])[0])
    if terminated or truncated:
        break
figure, (curves, view) = pyplot.subplots(1, 2, figsize=(9, 3.5), layout="constrained")
for name in envs.sim.term_names:
    curves.plot([each[name] for each in history], label=name)
curves.set_xlabel("generation")
curves.set_ylabel("mean return of each term")
curves.legend()
view.imshow(env.render())
view.set_axis_off()
picture = sys.argv[2] if len(sys.argv) > 2 else "crawl.png"
figure.savefig(picture, dpi=100)
print(f"wrote {picture}")
