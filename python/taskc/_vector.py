"""Many robots in a task as a Gymnasium VectorEnv."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from ._environment import MOST_SEED, check_render_mode, check_seed, metadata_of, warn_of_mode
from ._gymnasium import AutoresetMode, VectorEnv, limitless, unit
from ._outputs import Outputs, OutputsInTurn
from ._sim import Sim

Infos = Dict[str, Any]


def _masked(columns: Infos, over: np.ndarray) -> Infos:
    """One info for all, as Gymnasium has it: an array for each key, and beside it, under "_key",
    which environments have it."""
    masked: Infos = {}
    for key, column in columns.items():
        masked[key] = _masked(column, over) if isinstance(column, dict) else column
        masked["_" + key] = over
    return masked


class RobotVectorEnv(VectorEnv):
    """See taskc.make_vec(). All environments are stepped at once, in threads of the library.

    `infos` has "task" where episodes are over, as that of one environment (RobotEnv), each key with an
    array, and under "_key" for which environments it holds. With autoreset in the same step "final_obs"
    and "final_info" are there, too. `terms` says what the reward terms have paid in between.
    """

    def __init__(self, sim: Sim, autoreset_mode: AutoresetMode, copy: bool = True,
                 render_mode: Optional[str] = None, render_size: int = 256):
        check_render_mode(render_mode)
        self.sim = sim
        self.num_envs = sim.count
        self.metadata = {**metadata_of(sim), "autoreset_mode": autoreset_mode}
        self.render_mode = render_mode
        self.render_size = render_size
        self.observed = sim.observed
        self.single_observation_space = limitless((sim.observation_size,))
        self.single_action_space = unit((sim.action_size,))
        self.observation_space = limitless((sim.count, sim.observation_size))
        self.action_space = unit((sim.count, sim.action_size))
        self.closed = False
        self._copies = copy
        # Without autoreset the caller may reset some environments, and gets what the others have shown
        # last: what was handed out may have been changed.
        takes_turns = copy and autoreset_mode != AutoresetMode.DISABLED
        self._turns = OutputsInTurn(sim) if takes_turns else None
        self._outputs: Optional[Outputs] = None  # of the last step, unless the sim's own
        self._keeps_last = autoreset_mode == AutoresetMode.SAME_STEP
        self._was_reset = False
        self._no_one = np.zeros(sim.count, np.bool_)
        self._action_shape = (sim.count, sim.action_size)

    @property
    def dt(self) -> float:
        """How long a step is [s]; 0 where that differs."""
        return self.sim.decision_time

    def reset(self, *, seed: "Optional[Union[int, Sequence[Optional[int]]]]" = None,
              options: Optional[Dict[str, Any]] = None) -> Tuple[np.ndarray, Infos]:
        """Begins episodes. seed: of the first environment, the others following; or one for each;
        without, the next ones, or at first some that are drawn.
        options: {"reset_mask": [num_envs] of bool}: only in these environments."""
        which = None if options is None else options.get("reset_mask")
        if which is not None:
            self._check_mask("reset_mask", which)
        super().reset(seed=seed if isinstance(seed, int) else None)
        if self._outputs:
            self.sim.observations[...] = self._outputs.arrays[0]
        self.sim.reset(which, self._seeds(seed))
        self._was_reset = True
        return self._observations(), {}

    def _check_mask(self, name: str, mask: Any) -> None:
        if np.shape(mask) != (self.num_envs,):
            raise ValueError(f"{name} has the shape {np.shape(mask)}, not ({self.num_envs},)")

    def _seeds(self, seed: "Optional[Union[int, Sequence[Optional[int]]]]") -> Optional[List[int]]:
        if seed is None and self._was_reset:
            return None
        if seed is None:
            seed = int(self.np_random.integers(MOST_SEED - self.num_envs))
        if isinstance(seed, (int, np.integer)):
            seed = [int(seed) + i for i in range(self.num_envs)]
        if len(seed) != self.num_envs:
            raise ValueError(f"there are {len(seed)} seeds for {self.num_envs} environments")
        seeds = [int(self.np_random.integers(MOST_SEED)) if each is None else int(each)
                 for each in seed]
        for each in seeds:
            check_seed(each)
        return seeds

    def step(self, actions: Any) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, Infos]:
        sim = self.sim
        if getattr(actions, "shape", ()) != self._action_shape and (
                np.shape(actions) != self._action_shape):
            raise ValueError(f"actions have the shape {self._action_shape}, and these have "
                             f"{np.shape(actions)}")
        # Little is done here: after a step of the library all that Python needs is far from the
        # processor, and each further operation takes tens of microseconds.
        outputs = self._outputs = self._turns.next() if self._turns else None
        sim.step(actions, outputs and outputs.pointer)
        infos = self._ends() if sim.ended.value else {}
        if outputs:
            return (*outputs.arrays, infos)
        flags = sim.flags.copy()
        return self._observations(), sim.rewards.copy(), flags[0], flags[1], infos

    def _observations(self) -> np.ndarray:
        return self.sim.observations.copy() if self._copies else self.sim.observations

    def set(self, parameter: str, value: Any, which: "Optional[Sequence[bool]]" = None) -> None:
        """Sets a parameter, "task.weight", from the next step on, as `trainer ctl set` does: in all
        environments, or where `which` [num_envs] is true. A number may have its unit, "20 s"."""
        if which is not None:
            self._check_mask("which", which)
        self.sim.set(parameter, value, which)

    @property
    def terms(self) -> Dict[str, np.ndarray]:
        """What each reward term has paid so far, [num_envs], in the episodes that the last rewards are
        of."""
        return dict(zip(self.sim.term_names, self.sim.term_sums.T.copy()))

    def _ends(self) -> Infos:
        ended, task = self.sim.last_ends()
        over = self._no_one.copy()
        for i in ended:
            over[i] = True
        infos = _masked({"task": task}, over)
        if not self._keeps_last:
            return infos
        last = np.full(self.num_envs, None, object)
        for i in ended:
            last[i] = self.sim.final_observations[i].copy()
        return {**infos, "final_obs": last, "_final_obs": over, "final_info": infos,
                "_final_info": over}

    def render(self) -> Optional[Tuple[np.ndarray, ...]]:
        """A picture of each, uint8 [render_size, render_size, 3], with render_mode="rgb_array"."""
        if self.render_mode is None:
            warn_of_mode()
            return None
        return tuple(self.sim.render(i, self.render_size) for i in range(self.num_envs))

    def close_extras(self, **others: Any) -> None:
        del others
        self.sim.close()
        self.closed = True
