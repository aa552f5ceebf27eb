"""One running instance of a task."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional

import numpy as np

from . import _abi, _arrays, _describe
from ._library import Handle, library

if TYPE_CHECKING:
    from ._task import Task


@dataclass(frozen=True)
class Result:
    """What one event has done."""

    reward: float
    outcome: Optional[str]  # "success", "failure" or "truncated" where it has ended the episode
    reason: str  # why; "" where it has not
    fault: Optional[str]  # the first reward term that was not finite and not paid

    @property
    def has_ended(self) -> bool:
        return self.outcome is not None


class Instance:
    """Made by Task.instance(). Its sensors are NumPy arrays of its own until others are bound:

        instance = task.instance()
        instance.start_episode(seed=1)
        instance.sensors["base.velocity"][:] = velocity
        reward = instance.end_time_step(0.005).reward

    May be used by one thread at a time.
    """

    def __init__(self, task: "Task", params: Optional[Dict[str, float]] = None,
                 discount: float = 1.0):
        self.task = task
        self._library = library()
        self._handle = Handle(self._library.taskc_new_instance,
                              self._library.taskc_delete_instance, task._handle.pointer)
        self._pointer = self._handle.pointer
        self._result = _abi.Result()
        self._kept: Dict[str, Any] = {}  # what the library reads must not go away
        self.sensors: Dict[str, np.ndarray] = {}
        for name, sensor in task.sensors.items():
            self.bind(name, np.zeros(sensor.shape, sensor.dtype))
        for name, value in (params or {}).items():
            self.set_param(name, value)
        self._library.taskc_set_discount(self._pointer, discount)

    # ---- sensors, params, goals

    def bind(self, name: str, value: Any) -> None:
        """Reads the sensor, or an entry of it, from this array from now on; quaternions may be
        xyzw(array). The array must have a format of the library: other ones would be copies, which
        do not follow it."""
        sensor, shape = self._find(name)
        array, quaternions = _arrays.of_format(value)
        given = value.array if isinstance(value, _arrays.Quaternions) else value
        if not isinstance(given, np.ndarray) or not np.shares_memory(array, given) and array.size:
            raise TypeError(f"the sensor `{name}` needs an array of bool, uint8, int32, int64, "
                            "float32 or float64 that has no repeated elements")
        self._library.taskc_bind(self._pointer, name.encode(), None,
                                 _arrays.view(sensor, name, shape, array, quaternions))
        self._kept[name] = array
        self._forget(name, sensor.name)
        self.sensors[name] = array

    def bind_function(self, name: str, function: Callable[[], Any]) -> None:
        """Calls the function before each event that reads the sensor, or the entry of it."""
        sensor, shape = self._find(name)
        size = int(np.prod(shape, dtype=int)) * sensor.dtype.itemsize

        def write(user: Any, elements: Any) -> None:
            del user
            raw = np.ctypeslib.as_array(elements, (size,))
            raw.view(sensor.dtype).reshape(shape)[...] = function()

        kept = _abi.SENSOR_FUNCTION(write)
        self._library.taskc_bind_function(self._pointer, name.encode(), None, kept, None)
        self._kept[name] = kept
        self._forget(name, sensor.name)
        self.sensors.pop(name, None)

    def _forget(self, name: str, sensor: str) -> None:
        """A sensor is read from one array, or entry by entry."""
        others = [sensor] if name != sensor else [
            each for each in self.sensors if each.startswith(sensor + "[")]
        for each in others:
            self.sensors.pop(each, None)

    def _find(self, name: str) -> Any:
        found = _arrays.find(self.task.sensors, name)
        if found is None:
            raise KeyError(f"the task `{self.task.name}` reads no sensor `{name}`; it reads "
                           + ", ".join(f"`{each}`" for each in self.task.sensors))
        return found

    def set_param(self, name: str, value: float, unit: Optional[str] = None) -> None:
        """In SI units; `unit` is compared with the param's where it is given."""
        self._library.taskc_set_param(self._pointer, name.encode(),
                                      None if unit is None else unit.encode(), float(value))

    def param(self, name: str) -> float:
        value = ctypes.c_double()
        self._library.taskc_get_param(self._pointer, name.encode(), ctypes.byref(value))
        return value.value

    def goal(self, name: str) -> np.ndarray:
        """What the robot is told now."""
        shape = self.task.goals[name].shape if name in self.task.goals else ()
        elements = np.zeros(shape)
        self._library.taskc_get_goal(self._pointer, name.encode(), _doubles(elements))
        return elements

    def hold_goal(self, name: str, value: Any) -> None:
        """Tells the robot this, in this episode and later ones, until release_goal()."""
        shape = self.task.goals[name].shape if name in self.task.goals else ()
        elements = np.ascontiguousarray(np.broadcast_to(np.asarray(value, np.float64), shape))
        self._library.taskc_hold_goal(self._pointer, name.encode(), None, _doubles(elements))

    def release_goal(self, name: str) -> None:
        self._library.taskc_release_goal(self._pointer, name.encode())

    # ---- events, in the order of taskc/host.h

    def start_episode(self, seed: int = 0) -> Result:
        self._library.taskc_start_episode(self._pointer, seed, ctypes.byref(self._result))
        return self._outcome()

    def start_action(self) -> Result:
        return self._event(_abi.START_OF_ACTION, 0.0)

    def end_action(self) -> Result:
        return self._event(_abi.END_OF_ACTION, 0.0)

    def start_time_step(self, time_step: float) -> Result:
        return self._event(_abi.START_OF_TIME_STEP, time_step)

    def end_time_step(self, time_step: float) -> Result:
        return self._event(_abi.END_OF_TIME_STEP, time_step)

    def start_physics_step(self, time_step: float) -> Result:
        return self._event(_abi.START_OF_PHYSICS_STEP, time_step)

    def end_physics_step(self, time_step: float) -> Result:
        return self._event(_abi.END_OF_PHYSICS_STEP, time_step)

    def end_episode(self, outcome: str = "truncated") -> Result:
        """`outcome`: how it has ended, where the task itself has not ended it."""
        self._library.taskc_end_episode(self._pointer, _describe.OUTCOMES.index(outcome),
                                        ctypes.byref(self._result))
        return self._outcome()

    def _event(self, event: int, time_step: float) -> Result:
        self._library.taskc_event(self._pointer, event, time_step, ctypes.byref(self._result))
        return self._outcome()

    def _outcome(self) -> Result:
        result = self._result
        if result.end < 0 and result.violation < 0 and result.fault < 0:
            return Result(result.reward, None, "", None)
        return self._ended_result(result)

    def _ended_result(self, result: _abi.Result) -> Result:
        plugin = self.task._plugin
        fault = self.task.terms[result.fault].name if result.fault >= 0 else None
        outcome = None
        if result.violation >= 0:
            outcome = "truncated"
        elif result.end >= 0:
            outcome = _describe.OUTCOMES[plugin.ends[result.end].kind]
        return Result(result.reward, outcome,
                      _describe.reason(plugin, result.end, result.violation), fault)

    # ---- what the episode has come to

    @property
    def episode_return(self) -> float:
        return float(self._library.taskc_return(self._pointer))

    @property
    def outcome(self) -> Optional[str]:
        """None while nothing has ended the episode."""
        kind = self._library.taskc_ended(self._pointer, None)
        return None if kind < 0 else _describe.OUTCOMES[kind]

    @property
    def reason(self) -> str:
        """Why it has ended; "" where the task has not ended it."""
        reason = ctypes.c_char_p()
        self._library.taskc_ended(self._pointer, ctypes.byref(reason))
        return _describe.text(reason.value or b"")

    @property
    def terms(self) -> Dict[str, float]:
        """What each reward term has paid since the episode began."""
        return self._numbers("taskc_terms", [each.name for each in self.task.terms])

    @property
    def metrics(self) -> Dict[str, float]:
        """Complete after end_episode()."""
        return self._numbers("taskc_metrics", [each.name for each in self.task.metrics])

    @property
    def logs(self) -> Dict[str, float]:
        """Complete after end_episode()."""
        return self._numbers("taskc_logs", [each.name for each in self.task.logs])

    @property
    def phase(self) -> Optional[str]:
        number = self._library.taskc_present_phase(self._pointer)
        return None if number < 0 else self.task.phases[number]

    def observe(self) -> np.ndarray:
        """What the learner sees now; see Task.observations."""
        numbers = ctypes.POINTER(ctypes.c_double)()
        self._library.taskc_observe(self._pointer, ctypes.byref(numbers))
        size = self.task.observation_size
        return np.array(numbers[:size] if size else [], dtype=np.float64)

    def _numbers(self, function: str, names: List[str]) -> Dict[str, float]:
        if not names:
            return {}
        return dict(zip(names, getattr(self._library, function)(self._pointer)[:len(names)]))


def _doubles(array: np.ndarray) -> Any:
    return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double))
