"""Tasks, and what they pay for recorded episodes."""

from __future__ import annotations

import ctypes
import os
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Sequence, Union

import numpy as np

from . import _abi, _arrays, _compiler, _describe
from ._instance import Instance
from ._library import Handle, library

Sensors = Mapping[str, Any]


@dataclass(frozen=True)
class Evaluation:
    """What a task pays for a recorded episode."""

    episode_return: float
    terms: Dict[str, float]  # what each reward term has paid
    metrics: Dict[str, float]
    logs: Dict[str, float]
    outcome: str  # "success", "failure" or "truncated", also where the recording ends
    reason: str  # the end that was reached; "" where the recording ends
    time_steps: int  # until the end
    fault_count: int  # how often something was not paid, as it was not finite
    rewards: np.ndarray  # of each row; 0 after the end
    term_sums: Optional[np.ndarray]  # [row, term]: what each term has paid until then, if wanted


class Task:
    """A compiled task: what it reads, pays, measures and ends. See load()."""

    def __init__(self, plugin: "Union[str, os.PathLike[str]]",
                 warnings: "Sequence[_compiler.Diagnostic]" = (), source: Optional[str] = None):
        """Opens a plugin. Raises HostError for a file that is none, or not for this version.

        source: the .task file that it was compiled from, if that is known
        """
        self._library = library()
        self._handle = Handle(self._library.taskc_open, self._library.taskc_close,
                              os.fsencode(plugin))
        self._plugin = self._library.taskc_describe(self._handle.pointer).contents
        if self._plugin.struct_size != ctypes.sizeof(_abi.Plugin):
            raise AssertionError("taskc._abi does not say what taskc/plugin.h says")
        described = self._plugin
        self.file = os.fspath(plugin)
        self.source = source
        self.warnings = list(warnings)
        self.name: str = _describe.text(described.name)
        self.doc: str = _describe.text(described.doc)
        self.robot: str = _describe.text(described.robot)  # "" where it is for none
        self.links = _describe.names(described, "links")
        self.joints = _describe.names(described, "joints")
        self.sites = _describe.names(described, "sites")
        self.sensors = _describe.sensors(described)
        self.params = _describe.params(described)
        self.goals = _describe.goals(described)
        self.observations = _describe.observations(described)
        self.observation_size: int = described.observation_size
        self.phases = _describe.names(described, "phases")
        self.terms = _describe.terms(described)
        self.metrics = _describe.metrics(described)
        self.logs = _describe.logs(described)
        self.ends = _describe.ends(described)

    def __repr__(self) -> str:
        return f"<taskc.Task `{self.name}`: {len(self.sensors)} sensors, {len(self.terms)} terms>"

    def instance(self, params: Optional[Dict[str, float]] = None, discount: float = 1.0) -> Instance:
        """A running instance, with these params."""
        return Instance(self, params, discount)

    def evaluate(self, recorded: "Union[Sensors, Sequence[Sensors]]", *, time_step: float,
                 params: Optional[Dict[str, float]] = None, discount: float = 1.0,
                 goals: Optional[Dict[str, Any]] = None,
                 seed: "Union[int, Sequence[int]]" = 0, action_length: int = 1,
                 new_actions: Any = None, begins_with_start: bool = False,
                 ends_with_action: bool = False, with_term_sums: bool = False,
                 threads: int = 0) -> "Union[Evaluation, List[Evaluation]]":
        """What the task pays for an episode, or for each of a list of them.

        recorded: for each sensor that the task reads an array [time, ...] with the sensor's shape
            behind the axis of time; without that axis it never changes. Names may be those of
            entries, "joint.angle[left_knee]"; quaternions may be xyzw(array). What the task does not
            read is left out. Row k is the end of time step k. Arrays of float64, float32, int64,
            int32, uint8 and bool are read where they are, with any strides.
        time_step: [s]
        goals: values to hold them at; otherwise they are drawn
        seed: decides what is drawn; of several episodes one for each, or the first one's, to which
            the number of the episode is added
        action_length: how many time steps an action has; 0: one action is the whole episode
        new_actions: or, for each row, whether an action starts with its time step
        begins_with_start: the first row is the state in which the episode begins, no time step
        ends_with_action: an episode that is over goes on until the action is, too
        with_term_sums: also what each term has paid until each row; takes longer
        threads: 0: one for each processor; the result is the same for any number

        Raises HostError for sensors that are missing or of another kind, ValueError for shapes.
        """
        episodes = [recorded] if isinstance(recorded, Mapping) else list(recorded)
        seeds = [seed + i for i in range(len(episodes))] if isinstance(seed, int) else list(seed)
        actions = [new_actions] if isinstance(recorded, Mapping) else (
            [None] * len(episodes) if new_actions is None else list(new_actions))
        instance = self.instance(params, discount)
        for name, value in (goals or {}).items():
            instance.hold_goal(name, value)
        recordings = [
            _Recording(self, each, time_step=time_step, seed=seeds[i], action_length=action_length,
                       new_actions=actions[i], begins_with_start=begins_with_start,
                       ends_with_action=ends_with_action, with_term_sums=with_term_sums)
            for i, each in enumerate(episodes)
        ]
        count = len(recordings)
        inputs = (_abi.Recording * count)(*[each.recording for each in recordings])
        outputs = (_abi.Evaluation * count)(*[each.evaluation for each in recordings])
        self._library.taskc_evaluate(instance._pointer, inputs, count, threads, outputs)
        results = [each.result(output) for each, output in zip(recordings, outputs)]
        return results[0] if isinstance(recorded, Mapping) else results


class _Recording:
    """One episode as the library reads it, and the arrays that it fills."""

    def __init__(self, task: Task, sensors: Sensors, *, time_step: float, seed: int,
                 action_length: int, new_actions: Any, begins_with_start: bool,
                 ends_with_action: bool, with_term_sums: bool):
        self._task = task
        self._kept: List[Any] = []
        self._rows: Optional[int] = None
        columns = [self._column(name, value) for name, value in sensors.items()
                   if _arrays.find(task.sensors, name) is not None]
        if self._rows is None:
            raise ValueError(
                f"no array has an axis of time: the task `{task.name}` reads "
                + ", ".join(f"`{each.name}` {('time',) + each.shape}" for each in task.sensors.values()))
        rows = self._rows
        self._rewards = np.zeros(rows)
        self._term_sums = np.zeros((rows, len(task.terms))) if with_term_sums else None
        self._terms = np.zeros(len(task.terms))
        self._metrics = np.zeros(len(task.metrics))
        self._logs = np.zeros(len(task.logs))
        actions = None
        if new_actions is not None:
            actions = np.ascontiguousarray(np.asarray(new_actions, dtype=np.bool_))
            if actions.shape != (rows,):
                raise ValueError(f"new_actions has the shape {actions.shape}, not ({rows},)")
            self._kept.append(actions)
        self._columns = (_abi.Column * max(len(columns), 1))(*columns)
        self.recording = _abi.Recording(
            columns=self._columns, column_count=len(columns),
            begins_with_start=int(begins_with_start), rows=rows, time_step=time_step,
            seed=seed % 2**64, action_length=action_length,
            new_actions=None if actions is None else actions.ctypes.data,
            ends_with_action=int(ends_with_action), rewards=self._rewards.ctypes.data,
            term_sums=None if self._term_sums is None else self._term_sums.ctypes.data)
        self.evaluation = _abi.Evaluation(terms=self._terms.ctypes.data,
                                          metrics=self._metrics.ctypes.data,
                                          logs=self._logs.ctypes.data)

    def _column(self, name: str, value: Any) -> _abi.Column:
        found = _arrays.find(self._task.sensors, name)
        assert found is not None
        sensor, shape = found
        array, quaternions = _arrays.of_format(value)
        changes = array.ndim != len(shape)
        if changes:
            self._count_rows(name, array, ("time",) + shape)
        self._kept.append(array)
        return _abi.Column(
            sensor=name.encode(), unit=None,
            view=_arrays.view(sensor, name, shape, array, quaternions, axes=int(changes)),
            time_stride=array.strides[0] if changes else 0)

    def _count_rows(self, name: str, array: np.ndarray, wanted: Any) -> None:
        if array.ndim != len(wanted):
            raise ValueError(f"the sensor `{name}` needs an array with the axes {wanted}, and this one "
                             f"has the shape {array.shape}")
        if self._rows is None:
            self._rows = array.shape[0]
        elif self._rows != array.shape[0]:
            raise ValueError(f"the sensor `{name}` has {array.shape[0]} time steps, and others have "
                             f"{self._rows}")

    def result(self, output: _abi.Evaluation) -> Evaluation:
        task = self._task
        return Evaluation(
            episode_return=output.episode_return,
            terms=dict(zip([each.name for each in task.terms], self._terms.tolist())),
            metrics=dict(zip([each.name for each in task.metrics], self._metrics.tolist())),
            logs=dict(zip([each.name for each in task.logs], self._logs.tolist())),
            outcome=_describe.OUTCOMES[output.kind],
            reason=_describe.reason(task._plugin, output.end, output.violation),
            time_steps=output.time_steps, fault_count=output.fault_count, rewards=self._rewards,
            term_sums=self._term_sums)


def load(file: "Union[str, os.PathLike[str]]",
         robots: "Optional[Union[str, os.PathLike[str]]]" = None) -> Task:
    """A task from its .task file, compiled where that is needed, or from a plugin (.so).

    robots: a folder in which robots are looked for first.

    Raises TaskError, with the diagnostics as data, for a task with mistakes; CompilerError where taskc
    cannot do its work; HostError for a plugin that is damaged, or not of this version.
    """
    if os.fspath(file).endswith(".so"):
        return Task(file)
    plugin, diagnostics = _compiler.build(file, robots)
    return Task(plugin, diagnostics, os.fspath(file))
