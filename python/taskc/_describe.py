"""What a task says of itself, as plain Python."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Tuple

import numpy as np

from . import _abi

OUTCOMES = ("success", "failure", "truncated")
_SCALARS = {_abi.BOOL: np.dtype(np.bool_), _abi.INT: np.dtype(np.int64),
            _abi.REAL: np.dtype(np.float64)}
_REDUCTIONS = ("last", "sum", "max", "min", "mean")


@dataclass(frozen=True)
class Sensor:
    """Something that the task reads. Arrays over links, joints or sites are in the order of
    Task.links, Task.joints and Task.sites; quaternions are (w, x, y, z)."""

    name: str
    doc: str
    type: str  # as in the task: "vec3", "bool[link]"
    unit: str  # "m/s"; "" for a plain number
    shape: Tuple[int, ...]  # of its value at one time; () for a single number
    dtype: np.dtype
    minimum: float  # of each element; infinite where nothing is known
    maximum: float
    rows: int
    columns: int
    read_by: int

    @property
    def is_quaternion(self) -> bool:
        return self.type.startswith("quat")

    @property
    def is_array(self) -> bool:
        return self.type.endswith("]")


@dataclass(frozen=True)
class Param:
    """A number that may be set, in `unit`; bools and ints are numbers, too."""

    name: str
    doc: str
    unit: str
    initial: float
    minimum: float
    maximum: float


@dataclass(frozen=True)
class Goal:
    """What the robot is told: drawn at random, or held by the host."""

    name: str
    doc: str
    type: str
    unit: str
    shape: Tuple[int, ...]


@dataclass(frozen=True)
class Observation:
    """Some of what the learner sees: `size` numbers, from `offset` on."""

    name: str
    doc: str
    type: str
    unit: str
    offset: int
    size: int
    minimum: float
    maximum: float


@dataclass(frozen=True)
class Term:
    """A named part of the reward."""

    name: str
    doc: str


@dataclass(frozen=True)
class Metric:
    """One number of an episode: the last, sum, max, min or mean over its time steps."""

    name: str
    doc: str
    unit: str
    reduction: str


@dataclass(frozen=True)
class Log:
    """As Metric, over the times that the task has logged it."""

    name: str
    doc: str
    unit: str
    reduction: str


@dataclass(frozen=True)
class End:
    """A statement that ends an episode."""

    reason: str
    outcome: str  # "success", "failure" or "truncated"


def text(raw: bytes) -> str:
    return raw.decode("utf-8", "replace")


def entries(plugin: _abi.Plugin, table: str) -> List[Any]:
    """The entries of one of its tables."""
    count = next(count for name, count, _ in _abi.TABLES if name == table)
    return getattr(plugin, table)[:getattr(plugin, count)]


def _shape(entry: Any) -> Tuple[int, ...]:
    kind = text(entry.type)
    is_array = kind.endswith("]")
    if entry.columns > 1 or kind.startswith("mat"):
        return (entry.rows, entry.columns)
    return (entry.rows,) if is_array or entry.rows > 1 else ()


def sensors(plugin: _abi.Plugin) -> Dict[str, Sensor]:
    return {
        text(each.name): Sensor(text(each.name), text(each.doc), text(each.type), text(each.unit),
                                _shape(each), _SCALARS[each.scalar], each.minimum, each.maximum,
                                each.rows, each.columns, each.read_by)
        for each in entries(plugin, "sensors")
    }


def params(plugin: _abi.Plugin) -> Dict[str, Param]:
    return {
        text(each.name): Param(text(each.name), text(each.doc), text(each.unit), each.initial,
                               each.minimum, each.maximum)
        for each in entries(plugin, "params")
    }


def goals(plugin: _abi.Plugin) -> Dict[str, Goal]:
    return {
        text(each.name): Goal(text(each.name), text(each.doc), text(each.type), text(each.unit),
                              _shape(each))
        for each in entries(plugin, "goals")
    }


def observations(plugin: _abi.Plugin) -> List[Observation]:
    return [
        Observation(text(each.name), text(each.doc), text(each.type), text(each.unit), each.offset,
                    each.rows * each.columns, each.minimum, each.maximum)
        for each in entries(plugin, "observations")
    ]


def terms(plugin: _abi.Plugin) -> List[Term]:
    return [Term(text(each.name), text(each.doc)) for each in entries(plugin, "terms")]


def metrics(plugin: _abi.Plugin) -> List[Metric]:
    return [
        Metric(text(each.name), text(each.doc), text(each.unit), _REDUCTIONS[each.reduction])
        for each in entries(plugin, "metrics")
    ]


def logs(plugin: _abi.Plugin) -> List[Log]:
    return [
        Log(text(each.name), text(each.doc), text(each.unit), _REDUCTIONS[each.reduction])
        for each in entries(plugin, "logs")
    ]


def ends(plugin: _abi.Plugin) -> List[End]:
    return [End(text(each.reason), OUTCOMES[each.kind]) for each in entries(plugin, "ends")]


def names(plugin: _abi.Plugin, table: str) -> Tuple[str, ...]:
    return tuple(text(each.name) for each in entries(plugin, table))


def reason(plugin: _abi.Plugin, end: int, violation: int) -> str:
    """Why an episode has ended; "" where the task has not ended it."""
    if violation >= 0:
        return "requirement: " + text(plugin.requirements[violation].reason)
    return text(plugin.ends[end].reason) if end >= 0 else ""
