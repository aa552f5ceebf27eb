"""One of our robots in a task as a Gymnasium environment."""

from __future__ import annotations

import warnings
from typing import Any, Dict, Optional, Tuple

import numpy as np

from ._gymnasium import Env, limitless, unit
from ._sim import Episode, Sim

RENDER_MODES = ("rgb_array",)
MOST_SEED = 2**53 - 1  # the library takes 53 bits


def metadata_of(sim: Sim) -> Dict[str, Any]:
    """As Gymnasium has it of every environment."""
    fps = max(1, round(1 / sim.decision_time)) if sim.decision_time > 0 else 30
    return {"render_modes": list(RENDER_MODES), "render_fps": fps}


def check_render_mode(render_mode: Optional[str]) -> None:
    if render_mode is not None and render_mode not in RENDER_MODES:
        raise ValueError(f"there is no render_mode {render_mode!r}: it is None or \"rgb_array\"")


def check_seed(seed: int) -> None:
    if not 0 <= seed <= MOST_SEED:
        raise ValueError(f"the seed {seed} is not from 0 to 2**53 - 1")


def about(episode: Episode) -> Dict[str, Any]:
    """What `info["task"]` says of an episode that is over; as that of taskc.Wrapper."""
    return {"return": episode.episode_return, "terms": episode.terms, "metrics": episode.metrics,
            "logs": episode.logs, "outcome": episode.outcome, "reason": episode.reason,
            "number": episode.number, "time": episode.seconds}


def warn_of_mode() -> None:
    warnings.warn("render() shows nothing: make the environment with render_mode=\"rgb_array\"",
                  stacklevel=3)


class RobotEnv(Env):
    """See taskc.make().

    An action is a decision of the agent: with `ppo` offsets of joint targets from the robot's first
    pose, from -1 to 1; what is beyond is taken as it is. An observation is what the task observes, or
    else the robot's sensors; `observed` says what each number is.

    `info` has "terms", what each reward term has paid in the episode so far; and "task" when the
    episode is over: its return, terms, metrics, logs, outcome ("success", "failure", "truncated" or
    "diverged"), reason, number and time [s]. `terminated` is true after success and failure,
    `truncated` otherwise.
    """

    def __init__(self, sim: Sim, render_mode: Optional[str] = None, render_size: int = 256):
        check_render_mode(render_mode)
        self.sim = sim
        self.metadata = metadata_of(sim)
        self.render_mode = render_mode
        self.render_size = render_size
        self.observed = sim.observed
        self.observation_space = limitless((sim.observation_size,))
        self.action_space = unit((sim.action_size,))
        self._was_reset = False

    @property
    def dt(self) -> float:
        """How long a step is [s]; 0 where that differs."""
        return self.sim.decision_time

    def reset(self, *, seed: Optional[int] = None,
              options: Optional[Dict[str, Any]] = None) -> Tuple[np.ndarray, Dict[str, Any]]:
        """Begins an episode: of this seed the same each time; without one the next, or at first one
        that is drawn. `options` are not used."""
        if seed is not None:
            check_seed(seed)
        super().reset(seed=seed, options=options)
        if seed is None and not self._was_reset:
            seed = int(self.np_random.integers(MOST_SEED))
        self.sim.reset(seeds=None if seed is None else [seed])
        self._was_reset = True
        return self.sim.observations[0].copy(), {"terms": dict.fromkeys(self.sim.term_names, 0.0)}

    def step(self, action: Any) -> Tuple[np.ndarray, float, bool, bool, Dict[str, Any]]:
        sim = self.sim
        if np.shape(action) != self.action_space.shape:
            raise ValueError(f"an action has the shape {self.action_space.shape}, and this one has "
                             f"{np.shape(action)}")
        sim.step(action)
        terminated, truncated = sim.flags[:, 0].tolist()
        info: Dict[str, Any] = {"terms": dict(zip(sim.term_names, sim.term_sums[0].tolist()))}
        if terminated or truncated:
            info["task"] = about(sim.last_episode(0))
        return sim.observations[0].copy(), float(sim.rewards[0]), terminated, truncated, info

    def set(self, parameter: str, value: Any) -> None:
        """Sets a parameter, "task.weight", from the next step on, as `trainer ctl set` does: a number
        may have its unit, "20 s"."""
        self.sim.set(parameter, value)

    def render(self) -> Optional[np.ndarray]:
        """A picture, uint8 [render_size, render_size, 3], with render_mode="rgb_array"."""
        if self.render_mode is None:
            warn_of_mode()
            return None
        return self.sim.render(0, self.render_size)

    def close(self) -> None:
        self.sim.close()
