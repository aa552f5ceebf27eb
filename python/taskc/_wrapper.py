"""A Gymnasium environment that pays by a task."""

from __future__ import annotations

from typing import Any, Callable, Dict, Mapping, Optional, Tuple, Union

import numpy as np

from ._instance import Instance
from ._task import Task, load

try:
    from gymnasium import Wrapper as _Base
    from gymnasium.utils import RecordConstructorArgs as _Recorded
except ImportError:

    class _Base:  # type: ignore[no-redef]
        """What gymnasium.Wrapper does, where there is no Gymnasium."""

        def __init__(self, env: Any):
            self.env = env

        def __getattr__(self, name: str) -> Any:
            if name == "env":
                raise AttributeError(name)
            return getattr(self.env, name)

        @property
        def unwrapped(self) -> Any:
            return getattr(self.env, "unwrapped", self.env)

        def render(self) -> Any:
            return self.env.render()

        def close(self) -> None:
            self.env.close()

    class _Recorded:  # type: ignore[no-redef]
        """What `spec.make` builds a wrapper from again, where there is Gymnasium."""

        def __init__(self, **arguments: Any):
            del arguments


Source = Union[Callable[[Any, Any, Dict[str, Any]], Any], str, int, slice, Tuple[Any, ...], np.ndarray]


class Wrapper(_Base, _Recorded):
    """The environment `env` with the reward and the ends of a task:

        env = taskc.Wrapper(gymnasium.make("Pendulum-v1"), "swing.task", time_step=0.05, sensors={
            "pole.height": 0,                                          # an index into the observation
            "pole.rate": lambda env, observation, info: env.unwrapped.state[1],
        })

    sensors: for each that the task reads, where it comes from: a function of the unwrapped environment,
        the observation and the info; an index into the observation (a number, a slice, a list of
        them); or the name of an entry of the observation, or of the info, where these are mappings.
    time_step: [s] of one step; by default what the environment calls `dt`.
    params, discount: of the task.
    keep_ends: also end where the environment terminates, as a failure. Without it, what the
        environment calls terminated is only told in `info`: it must be one that can go on.

    A step is a time step and an action of the task. What the environment truncates is truncated.
    `info` holds "env_reward" and "env_terminated" in each step, and "task" when the episode is over:
    its return, terms, metrics, logs, outcome and reason. `reset(seed=...)` seeds the environment, and
    the task's own draws; later episodes have other ones.
    """

    def __init__(self, env: Any, task: "Union[Task, str]", sensors: Mapping[str, Source], *,
                 time_step: Optional[float] = None, params: Optional[Dict[str, float]] = None,
                 discount: float = 1.0, keep_ends: bool = False):
        _Recorded.__init__(self, task=task, sensors=sensors, time_step=time_step, params=params,
                           discount=discount, keep_ends=keep_ends, _disable_deepcopy=True)
        _Base.__init__(self, env)
        self.task: Task = task if isinstance(task, Task) else load(task)
        self.instance: Instance = self.task.instance(params, discount)
        self._keep_ends = keep_ends
        self._time_step = self._length(time_step)
        self._sources = dict(sensors)
        self._seed = 0
        self._is_running = False
        missing = [name for name in self.task.sensors if name not in self._sources]
        unknown = [name for name in self._sources if name not in self.task.sensors]
        if missing or unknown:
            raise ValueError(
                f"the task `{self.task.name}` reads {sorted(self.task.sensors)}; sensors has "
                + " and ".join(filter(None, [f"no {missing}" if missing else "",
                                             f"{unknown}, which it does not read" if unknown else ""])))

    def _length(self, time_step: Optional[float]) -> float:
        if time_step is None:
            time_step = getattr(self.unwrapped, "dt", None)
        if time_step is None:
            raise ValueError("the environment has no `dt`: say how long a step is by time_step=")
        return float(time_step)

    def reset(self, *, seed: Optional[int] = None,
              options: Optional[Dict[str, Any]] = None) -> Tuple[Any, Dict[str, Any]]:
        observation, info = self.env.reset(seed=seed, options=options)
        if self._is_running:  # the last episode was left in its middle
            self.instance.end_episode()
        self._seed = self._seed + 1 if seed is None else seed
        self._sense(observation, info)
        self.instance.start_episode(self._seed % 2**64)
        self._is_running = True
        return observation, info

    def step(self, action: Any) -> Tuple[Any, float, bool, bool, Dict[str, Any]]:
        instance = self.instance
        reward = instance.start_action().reward
        reward += instance.start_time_step(self._time_step).reward
        reward += instance.start_physics_step(self._time_step).reward
        observation, env_reward, env_terminated, env_truncated, info = self.env.step(action)
        self._sense(observation, info)
        reward += instance.end_physics_step(self._time_step).reward
        reward += instance.end_time_step(self._time_step).reward
        outcome = instance.outcome
        if outcome is None:  # the task has not stopped within the action
            reward += instance.end_action().reward
            outcome = instance.outcome
        if outcome is None and env_terminated and self._keep_ends:
            outcome = "failure"
        if outcome is None and env_truncated:
            outcome = "truncated"
        info = {**info, "env_reward": env_reward, "env_terminated": bool(env_terminated)}
        if outcome is not None:
            reward += self._end(outcome, info)
        return observation, reward, outcome in ("success", "failure"), outcome == "truncated", info

    def _end(self, outcome: str, info: Dict[str, Any]) -> float:
        instance = self.instance
        reward = instance.end_episode(outcome).reward
        self._is_running = False
        info["task"] = {
            "return": instance.episode_return, "terms": instance.terms, "metrics": instance.metrics,
            "logs": instance.logs, "outcome": outcome, "reason": instance.reason,
        }
        return reward

    def _sense(self, observation: Any, info: Dict[str, Any]) -> None:
        for name, source in self._sources.items():
            self.instance.sensors[name][...] = self._value(source, observation, info)

    def _value(self, source: Source, observation: Any, info: Dict[str, Any]) -> Any:
        if callable(source):
            return source(self.unwrapped, observation, info)
        if isinstance(source, str):
            is_observed = isinstance(observation, Mapping) and source in observation
            return observation[source] if is_observed else info[source]
        return observation[source]
