"""Arrays that a step fills, handed out without a copy for as long as nobody keeps the ones before."""

from __future__ import annotations

import ctypes
from ctypes import byref
from sys import getrefcount
from typing import List, Optional

import numpy as np

from . import _sim_abi
from ._sim import Sim


class Outputs:
    """Observations, rewards, and who was terminated or truncated, in one step."""

    def __init__(self, sim: Sim):
        self.arrays = (np.zeros_like(sim.observations), np.zeros(sim.count),
                       np.zeros(sim.count, np.bool_), np.zeros(sim.count, np.bool_))
        observations, rewards, terminated, truncated = (each.ctypes.data for each in self.arrays)
        self._struct = _sim_abi.Arrays(
            observations, sim.final_observations.ctypes.data, rewards, terminated, truncated,
            sim.term_sums.ctypes.data, ctypes.addressof(sim.ended))
        self.pointer = byref(self._struct)
        self._alone = self._holders()

    def _holders(self) -> List[int]:
        return [getrefcount(each) for each in self.arrays]

    def is_free(self) -> bool:
        """Whether nobody has one of the arrays, nor a view of it, which holds the array, too."""
        return self._holders() == self._alone


class OutputsInTurn:
    """Copies are most of what Python does after a step, and new memory costs page faults: so a few
    arrays take turns."""

    def __init__(self, sim: Sim):
        self._all = [Outputs(sim) for _ in range(3)]

    def next(self) -> Optional[Outputs]:
        """That may be written into; None where all are kept by somebody."""
        return next((each for each in self._all if each.is_free()), None)
