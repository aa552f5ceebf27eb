"""Compiled tasks in Python: what a robot is paid for, and when an episode ends.

    import taskc

    task = taskc.load("crawling.task")              # compiles it where needed
    result = task.evaluate(recorded, time_step=0.005)
    print(result.episode_return, result.terms, result.reason)

`taskc.Wrapper` gives a Gymnasium environment the reward and the ends of a task. docs/hosts.md says more.

Needs NumPy, the library libtaskc and, for tasks that are not compiled yet, the program `taskc`. Both
are looked for below TASKC_HOME where that is set; else beside this package where taskc was installed
with it, then where `taskc` is in PATH; the library also where the system has it.
"""

from ._arrays import xyzw
from ._compiler import Diagnostic, Fix, Label
from ._describe import Goal, Log, Metric, Observation, Param, Sensor, Term
from ._errors import CompilerError, HostError, TaskError
from ._instance import Instance, Result
from ._task import Evaluation, Task, load
from ._wrapper import Wrapper

__all__ = [
    "CompilerError", "Diagnostic", "Evaluation", "Fix", "Goal", "HostError", "Instance", "Label", "Log",
    "Metric", "Observation", "Param", "Result", "Sensor", "Task", "TaskError", "Term", "Wrapper",
    "load", "xyzw",
]
