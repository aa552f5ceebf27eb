"""The environments of libtaskc_sim, and the arrays that they fill."""

from __future__ import annotations

import ctypes
import os
from ctypes import byref, c_char_p, c_uint32
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _describe, _sim_abi
from ._library import Handle

OUTCOMES = _describe.OUTCOMES + ("diverged",)


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
        self._library = _sim_abi.library()
        options = _sim_abi.Options()
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
    def _observed(about: _sim_abi.Description) -> "Tuple[_describe.Observation, ...]":
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
        self._arrays = _sim_abi.Arrays(*[
            array.ctypes.data for array in (self.observations, self.final_observations, self.rewards,
                                            self.flags[0], self.flags[1], self.term_sums)])
        self._arrays.ended = ctypes.addressof(self.ended)
        self._arrays_pointer = byref(self._arrays)
        self._actions_address = self.actions.ctypes.data
        self._observations_address = self.observations.ctypes.data
        self._step = self._library.taskc_sim_step

        self._make_ends()

    def _make_ends(self) -> None:
        """What last_ends() fills: a row for each number of an episode."""
        count = self.count
        terms = 2 + len(self.term_names)
        metrics = terms + len(self._metric_names)
        values = np.zeros((metrics + len(self._log_names), count))
        self._end_numbers = np.zeros(count, np.int64)
        self._end_kinds = np.zeros(count, np.int32)
        self._end_reasons = (c_char_p * count)()
        self._end_rows = list(values)
        self._nothing = np.full(count, None, object)
        self._ends = _sim_abi.Ends(
            self._end_numbers.ctypes.data, self._end_kinds.ctypes.data,
            ctypes.addressof(self._end_reasons),
            *[values[i:].ctypes.data for i in (0, 1, 2, terms, metrics)])
        self._ends_pointer = byref(self._ends)

    def reset(self, which: Optional[np.ndarray] = None,
              seeds: Optional[Sequence[int]] = None) -> None:
        """Begins episodes: in all environments, or where `which` [count] is true."""
        mask = None if which is None else np.ascontiguousarray(which, np.bool_)
        numbers = None if seeds is None else np.array([each % 2**64 for each in seeds], np.uint64)
        self._library.taskc_sim_reset(
            self._handle.pointer, None if mask is None else mask.ctypes.data,
            None if numbers is None else numbers.ctypes.data, self._observations_address)

    def step(self, actions: Any, arrays: Any = None) -> None:
        """A decision in each environment: [count, action_size], or whatever fits into that. `arrays`:
        a pointer to those that are filled instead of this object's."""
        self.actions[...] = actions
        self._step(self._handle.pointer, self._actions_address, arrays or self._arrays_pointer)

    def set(self, parameter: str, value: Any, which: Optional[np.ndarray] = None) -> None:
        """Sets a parameter from the next decision on: in all environments, or where `which` [count]
        is true."""
        mask = None if which is None else np.ascontiguousarray(which, np.bool_)
        self._library.taskc_sim_set(self._handle.pointer,
                                    None if mask is None else mask.ctypes.data,
                                    parameter.encode(), _text_of(value).encode())

    def last_episode(self, environment: int) -> Episode:
        """The one that has ended last there."""
        episode = _sim_abi.Episode()
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

    def last_ends(self) -> Tuple[List[int], Dict[str, Any]]:
        """In which environments an episode has ended in the last step, and what the task says of
        these: an array [count] for each key, with 0 or None where none has."""
        self._library.taskc_sim_last_ends(self._handle.pointer, self._ends_pointer)
        kinds = self._end_kinds.tolist()
        ended = [i for i, kind in enumerate(kinds) if kind >= 0]
        outcomes, reasons = self._nothing.copy(), self._nothing.copy()
        for i in ended:
            outcomes[i] = OUTCOMES[kinds[i]]
            reasons[i] = _describe.text(self._end_reasons[i])
        # One after the other: small arrays get memory that was used before.
        returns, seconds, *others = [row.copy() for row in self._end_rows]
        rows = iter(others)
        return ended, {
            "return": returns, "terms": dict(zip(self.term_names, rows)),
            "metrics": dict(zip(self._metric_names, rows)),
            "logs": dict(zip(self._log_names, rows)), "outcome": outcomes, "reason": reasons,
            "number": self._end_numbers.copy(), "time": seconds}

    def render(self, environment: int, size: int) -> np.ndarray:
        """A picture, uint8 [size, size, 3]."""
        picture = np.zeros((max(size, 1), max(size, 1), 3), np.uint8)
        self._library.taskc_sim_render(self._handle.pointer, environment, size, picture.ctypes.data)
        return picture

    def close(self) -> None:
        """Ends the environments and their threads."""
        self._handle.end()


def _text_of(value: Any) -> str:
    """The value of a parameter as the library takes it: "true", "0.5", "[0.4, 1.2]"."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, str):
        return value
    if np.ndim(value) > 0:
        return "[" + ", ".join(_text_of(each) for each in value) + "]"
    return repr(value.item() if isinstance(value, np.generic) else value)


def settings_of(settings: Mapping[str, Any]) -> Sequence[str]:
    """{"environment.random_friction": [0.4, 1.2]} as the library takes it: MODULE.PARAMETER=VALUE."""
    return [f"{name}={_text_of(value)}" for name, value in settings.items()]
