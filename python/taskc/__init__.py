"""Compiled tasks in Python: what a robot is paid for, and when an episode ends.

    import taskc

    task = taskc.load("crawling.task")              # compiles it where needed
    result = task.evaluate(recorded, time_step=0.005)
    print(result.episode_return, result.terms, result.reason)

    envs = taskc.make_vec("crawling", num_envs=64)  # our robots in a task, as Gymnasium has environments
    observations, infos = envs.reset(seed=1)

`taskc.make` makes one of them; `taskc.Wrapper` gives any Gymnasium environment the reward and the ends of
a task. docs/hosts.md says more.

Needs NumPy, the library libtaskc (for make and make_vec libtaskc_sim) and, for tasks that are not
compiled yet, the program `taskc`. All are looked for below TASKC_HOME where that is set; else beside this package where taskc was installed
with it, then where `taskc` is in PATH; the libraries also where the system has it.
"""

from ._arrays import xyzw
from ._compiler import Diagnostic, Fix, Label
from ._describe import Goal, Log, Metric, Observation, Param, Sensor, Term
from ._environment import RobotEnv
from ._errors import CompilerError, HostError, TaskError
from ._gymnasium import AutoresetMode
from ._instance import Instance, Result
from ._make import make, make_vec
from ._task import Evaluation, Task, load
from ._vector import RobotVectorEnv
from ._wrapper import Wrapper

__all__ = [
    "AutoresetMode", "CompilerError", "Diagnostic", "Evaluation", "Fix", "Goal", "HostError", "Instance",
    "Label", "Log", "Metric", "Observation", "Param", "Result", "RobotEnv", "RobotVectorEnv", "Sensor",
    "Task", "TaskError", "Term", "Wrapper", "load", "make", "make_vec", "xyzw",
]
