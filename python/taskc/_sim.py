"""libtaskc_sim by ctypes: the structs of taskc/sim.h, and its environments."""

from __future__ import annotations

import ctypes
import os
from ctypes import (POINTER, Structure, byref, c_char_p, c_double, c_int32, c_int64, c_size_t,
                    c_uint32, c_uint64, c_void_p)
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Dict, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _abi, _describe
from ._library import Handle, load

NEXT_STEP, SAME_STEP, DISABLED = range(3)
OUTCOMES = _describe.OUTCOMES + ("diverged",)


class _Options(Structure):
    _fields_ = [("struct_size", c_size_t), ("plugin", c_char_p), ("task", c_char_p),
                ("robot", c_char_p), ("robots", c_char_p), ("agent", c_char_p),
                ("profile", c_char_p), ("settings", POINTER(c_char_p)), ("setting_count", c_size_t),
                ("seed", c_uint64), ("discount", c_double), ("count", c_uint32),
                ("threads", c_uint32), ("autoreset", c_int32)]


class _Observation(Structure):
    _fields_ = [("name", c_char_p), ("type", c_char_p), ("unit", c_char_p), ("size", c_uint32),
                ("minimum", c_double), ("maximum", c_double)]


class _Description(Structure):
    _fields_ = [("task", POINTER(_abi.Plugin)), ("robot", c_char_p), ("profile", c_char_p),
                ("time_step", c_double), ("decision_time", c_double), ("count", c_uint32),
                ("threads", c_uint32), ("action_size", c_uint32), ("observation_size", c_uint32),
                ("observation_count", c_uint32), ("observations", POINTER(_Observation))]


class _Arrays(Structure):
    _fields_ = [(name, c_void_p) for name in ("observations", "final_observations", "rewards",
                                              "terminated", "truncated", "term_sums",
                                              "ended")]


class _Episode(Structure):
    _fields_ = [("number", c_int64), ("actions", c_int64), ("time_steps", c_int64),
                ("seconds", c_double), ("episode_return", c_double), ("kind", c_int32),
                ("reason", c_char_p), ("fault_count", c_int64), ("terms", POINTER(c_double)),
                ("metrics", POINTER(c_double)), ("logs", POINTER(c_double))]


_FUNCTIONS = {
    "taskc_sim_new": [POINTER(_Options), POINTER(c_void_p)],
    "taskc_sim_reset": [c_void_p, c_void_p, c_void_p, c_void_p],
    "taskc_sim_step": [c_void_p, c_void_p, POINTER(_Arrays)],
    "taskc_sim_last_episode": [c_void_p, c_uint32, POINTER(_Episode)],
    "taskc_sim_render": [c_void_p, c_uint32, c_uint32, c_void_p],
}
_OTHERS = {
    "taskc_sim_error": (c_char_p, []),
    "taskc_sim_abi_version": (c_uint32, []),
    "taskc_sim_defaults": (None, [POINTER(_Options), c_size_t]),
    "taskc_sim_delete": (None, [c_void_p]),
    "taskc_sim_describe": (POINTER(_Description), [c_void_p]),
}


@lru_cache(maxsize=None)
def library() -> Any:
    """libtaskc_sim, loaded once."""
    return load("libtaskc_sim", _FUNCTIONS, _OTHERS, "taskc_sim_error", "taskc_sim_abi_version")


@dataclass(frozen=True)
class Episode:
    """What a task says of an episode that is over."""

    number: int  # in the run: with the seed K it is K + 1
    actions: int
    time_steps: int
    seconds: float  # of the robot's time
    episode_return: float
    terms: Dict[str, float]  # what each reward term has paid
    metrics: Dict[str, float]
    logs: Dict[str, float]
    outcome: str  # "success", "failure", "truncated", or "diverged": not to be learned from
    reason: str
    fault_count: int  # how often something was not paid, as it was not finite or too large


def _encoded(text: "Optional[Union[str, os.PathLike[str]]]") -> Optional[bytes]:
    return None if text is None else os.fsencode(text)


class Sim:
    """Environments of one task, as the library has them, and the arrays that it fills.

    The arrays are the same objects all the time, and hold what the last reset() or step() has
    written.
    """

    def __init__(self, plugin: str, *, task: Optional[str], robot: Optional[str],
                 robots: "Optional[Union[str, os.PathLike[str]]]", agent: Optional[str],
                 profile: Optional[str], settings: Sequence[str], seed: int, discount: float,
                 count: int, threads: int, autoreset: int):
        self._library = library()
        options = _Options()
        self._library.taskc_sim_defaults(byref(options), ctypes.sizeof(options))
        options.plugin, options.task = _encoded(plugin), _encoded(task)
        options.robot, options.robots = _encoded(robot), _encoded(robots)
        options.profile = _encoded(profile)
        if agent is not None:
            options.agent = _encoded(agent)
        options.settings = (c_char_p * max(len(settings), 1))(*[each.encode() for each in settings])
        options.setting_count = len(settings)
        options.seed, options.discount = seed, discount
        options.count, options.threads, options.autoreset = count, threads, autoreset
        self._handle = Handle(self._library.taskc_sim_new, self._library.taskc_sim_delete,
                              byref(options))
        about = self._library.taskc_sim_describe(self._handle.pointer).contents
        plugin_table = about.task.contents
        self.count = count
        self.robot: str = _describe.text(about.robot)
        self.profile: str = _describe.text(about.profile)
        self.time_step: float = about.time_step
        self.decision_time: float = about.decision_time
        self.threads: int = about.threads
        self.action_size: int = about.action_size
        self.observation_size: int = about.observation_size
        self.observed = self._observed(about)
        self.term_names = _describe.names(plugin_table, "terms")
        self._metric_names = _describe.names(plugin_table, "metrics")
        self._log_names = _describe.names(plugin_table, "logs")
        self._make_arrays()

    @staticmethod
    def _observed(about: _Description) -> "Tuple[_describe.Observation, ...]":
        observed = []
        offset = 0
        for each in about.observations[:about.observation_count]:
            observed.append(_describe.Observation(
                _describe.text(each.name), "", _describe.text(each.type), _describe.text(each.unit),
                offset, each.size, each.minimum, each.maximum))
            offset += each.size
        return tuple(observed)

    def _make_arrays(self) -> None:
        count = self.count
        self.actions = np.zeros((count, self.action_size), np.float32)
        self.observations = np.zeros((count, self.observation_size), np.float32)
        self.final_observations = np.zeros_like(self.observations)
        self.rewards = np.zeros(count)
        self.flags = np.zeros((2, count), np.bool_)  # terminated, truncated
        self.ended = c_uint32()  # how many episodes have ended
        self.term_sums = np.zeros((count, len(self.term_names)))
        # Their addresses: asking an array for its own takes longer than a call of the library.
        self._arrays = _Arrays(*[
            array.ctypes.data for array in (self.observations, self.final_observations, self.rewards,
                                            self.flags[0], self.flags[1], self.term_sums)])
        self._arrays.ended = ctypes.addressof(self.ended)
        self._arrays_pointer = byref(self._arrays)
        self._actions_address = self.actions.ctypes.data
        self._observations_address = self.observations.ctypes.data
        self._step = self._library.taskc_sim_step

    def reset(self, which: Optional[np.ndarray] = None,
              seeds: Optional[Sequence[int]] = None) -> None:
        """Begins episodes: in all environments, or where `which` [count] is true."""
        mask = None if which is None else np.ascontiguousarray(which, np.bool_)
        numbers = None if seeds is None else np.array([each % 2**64 for each in seeds], np.uint64)
        self._library.taskc_sim_reset(
            self._handle.pointer, None if mask is None else mask.ctypes.data,
            None if numbers is None else numbers.ctypes.data, self._observations_address)

    def step(self, actions: Any) -> None:
        """A decision in each environment: [count, action_size], or whatever fits into that."""
        self.actions[...] = actions
        self._step(self._handle.pointer, self._actions_address, self._arrays_pointer)

    def last_episode(self, environment: int) -> Episode:
        """The one that has ended last there."""
        episode = _Episode()
        self._library.taskc_sim_last_episode(self._handle.pointer, environment, byref(episode))

        def named(names: Sequence[str], values: Any) -> Dict[str, float]:
            return dict(zip(names, values[:len(names)]))

        return Episode(
            number=episode.number, actions=episode.actions, time_steps=episode.time_steps,
            seconds=episode.seconds, episode_return=episode.episode_return,
            terms=named(self.term_names, episode.terms),
            metrics=named(self._metric_names, episode.metrics),
            logs=named(self._log_names, episode.logs), outcome=OUTCOMES[episode.kind],
            reason=_describe.text(episode.reason), fault_count=episode.fault_count)

    def render(self, environment: int, size: int) -> np.ndarray:
        """A picture, uint8 [size, size, 3]."""
        picture = np.zeros((max(size, 1), max(size, 1), 3), np.uint8)
        self._library.taskc_sim_render(self._handle.pointer, environment, size, picture.ctypes.data)
        return picture

    def close(self) -> None:
        """Ends the environments and their threads."""
        self._handle.end()


def settings_of(settings: Mapping[str, Any]) -> Sequence[str]:
    """{"environment.random_friction": [0.4, 1.2]} as the library takes it: MODULE.PARAMETER=VALUE."""

    def text(value: Any) -> str:
        if isinstance(value, (bool, np.bool_)):
            return "true" if value else "false"
        if isinstance(value, str):
            return value
        if np.ndim(value) > 0:
            return "[" + ", ".join(text(each) for each in value) + "]"
        return repr(value.item() if isinstance(value, np.generic) else value)

    return [f"{name}={text(value)}" for name, value in settings.items()]
