"""From what a user says of a task to its environments."""

from __future__ import annotations

import os
from typing import Any, Dict, Mapping, Optional, Union

from . import _find
from ._environment import RobotEnv
from ._gymnasium import AutoresetMode
from ._sim import Sim, settings_of
from ._sim_abi import DISABLED, NEXT_STEP, SAME_STEP
from ._task import Task, load
from ._vector import RobotVectorEnv

Path = Union[str, "os.PathLike[str]"]

_MODES = {AutoresetMode.NEXT_STEP: NEXT_STEP, AutoresetMode.SAME_STEP: SAME_STEP,
          AutoresetMode.DISABLED: DISABLED}


def _file_of(task: Path) -> str:
    """A path stays what it is; a name is that of a task that comes with taskc."""
    name = os.fspath(task)
    if name.endswith((".task", ".so")):
        return name
    found = _find.shared_task(name)
    if found is None:
        known = ", ".join(_find.shared_task_names()) or "none"
        raise ValueError(f"there is no task `{name}`; a path ends in .task or .so, and these tasks come "
                         f"with taskc: {known}")
    return str(found)


def _sim(task: Union[Path, Task], *, robot: Optional[str], robots: Optional[Path],
         agent: Optional[Path], profile: Optional[str], settings: Optional[Mapping[str, Any]],
         run_seed: int, discount: float, count: int, threads: int, autoreset: int) -> Sim:
    loaded = task if isinstance(task, Task) else load(_file_of(task), robots)
    has_robot = bool(loaded.robot or robot)
    return Sim(loaded.file, task=loaded.source, robot=robot, robots=robots,
               agent=None if agent is None else os.fspath(agent),
               profile=profile if has_robot else None, settings=settings_of(settings or {}),
               seed=run_seed, discount=discount, count=count, threads=threads, autoreset=autoreset)


def make(task: Union[Path, Task], *, robot: Optional[str] = None, robots: Optional[Path] = None,
         profile: Optional[str] = "fast-tree", agent: Optional[Path] = None,
         settings: Optional[Mapping[str, Any]] = None, run_seed: int = 0, discount: float = 0.99,
         render_mode: Optional[str] = None, render_size: int = 256) -> RobotEnv:
    """One of our robots in a task, as a Gymnasium environment:

        env = taskc.make("crawling", render_mode="rgb_array")
        observation, info = env.reset(seed=1)
        observation, reward, terminated, truncated, info = env.step(env.action_space.sample())

    task: the name of a task that comes with taskc, a .task file, which is compiled where needed, a
        plugin (.so), or a Task
    robot: of a task that names none
    robots: a folder in which robots are looked for first
    profile: how to simulate: "paper", "fast", "paper-tree", "fast-tree", "mujoco"; None: as the agent
        says. A task without a robot has none
    agent: what a decision and an observation are: one of the robot's agents, or an agent file, whose
        learner decides on vectors; by default "ppo"
    settings: as `trainer train --set`: {"task.weight": 2.0, "action_space.hold": 4,
        "environment.random_friction": [0.4, 1.2]}
    run_seed: after reset(seed=K) everything goes as in episode K + 1 of a run of the trainer with this
        seed
    discount: of the learner, for a task that pays a potential
    render_mode: None, or "rgb_array"
    render_size: width and height of a picture [px]

    Raises TaskError for a task with mistakes, HostError where task, robot, agent and settings do not
    fit, ValueError for a name that is none.
    """
    sim = _sim(task, robot=robot, robots=robots, agent=agent, profile=profile, settings=settings,
               run_seed=run_seed, discount=discount, count=1, threads=1, autoreset=DISABLED)
    return RobotEnv(sim, render_mode, render_size)


def make_vec(task: Union[Path, Task], num_envs: int = 1, *, robot: Optional[str] = None,
             robots: Optional[Path] = None, profile: Optional[str] = "fast-tree",
             agent: Optional[Path] = None, settings: Optional[Mapping[str, Any]] = None,
             run_seed: int = 0, discount: float = 0.99, threads: int = 0,
             autoreset_mode: "Union[AutoresetMode, str]" = AutoresetMode.NEXT_STEP,
             copy: bool = True, render_mode: Optional[str] = None,
             render_size: int = 256) -> RobotVectorEnv:
    """Many of them, stepped by threads of the library, as a Gymnasium VectorEnv:

        envs = taskc.make_vec("crawling", num_envs=64)
        observations, infos = envs.reset(seed=1)
        observations, rewards, terminations, truncations, infos = envs.step(actions)

    threads: 0: one for each processor; the numbers are the same for any number
    autoreset_mode: what becomes of an environment whose episode is over; "NextStep", "SameStep",
        "Disabled" or Gymnasium's AutoresetMode. envs.metadata says which
    copy: observations are copies; without, they are an array that the next step overwrites

    All else is as in make(). Environment i runs episode K + 1 + i after reset(seed=K), and goes on in
    steps of num_envs, so that no two run the same.
    """
    mode = AutoresetMode(autoreset_mode)
    sim = _sim(task, robot=robot, robots=robots, agent=agent, profile=profile, settings=settings,
               run_seed=run_seed, discount=discount, count=num_envs, threads=threads,
               autoreset=_MODES[mode])
    return RobotVectorEnv(sim, mode, copy, render_mode, render_size)
