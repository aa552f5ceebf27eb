"""What is taken from Gymnasium where that is installed (1.1 or newer), and what stands in for it where
it is not."""

from __future__ import annotations

import enum
from typing import Any, Dict, Optional, Tuple

import numpy as np

try:
    from gymnasium import Env
    from gymnasium.spaces import Box
    from gymnasium.vector import AutoresetMode, VectorEnv
except ImportError:

    class Box:  # type: ignore[no-redef]
        """The arrays of one shape whose numbers lie between two limits."""

        def __init__(self, low: Any, high: Any, shape: Optional[Tuple[int, ...]] = None,
                     dtype: Any = np.float32, seed: Optional[int] = None):
            self.dtype = np.dtype(dtype)
            self.shape = tuple(np.shape(low) if shape is None else shape)
            self.low = np.full(self.shape, low, self.dtype)
            self.high = np.full(self.shape, high, self.dtype)
            self.seed(seed)

        def seed(self, seed: Optional[int] = None) -> None:
            self.np_random = np.random.default_rng(seed)

        def contains(self, x: Any) -> bool:
            return bool(isinstance(x, np.ndarray) and np.can_cast(x.dtype, self.dtype)
                        and x.shape == self.shape and np.all(x >= self.low)
                        and np.all(x <= self.high))

        def __contains__(self, x: Any) -> bool:
            return self.contains(x)

        def sample(self, mask: Any = None) -> np.ndarray:
            """Uniform where there are limits, else normal."""
            if mask is not None:
                raise ValueError("a Box cannot be sampled with a mask")
            limited = np.isfinite(self.low) & np.isfinite(self.high)
            drawn = self.np_random.standard_normal(self.shape)
            drawn[limited] = self.np_random.uniform(self.low[limited], self.high[limited])
            return drawn.astype(self.dtype)

        def __eq__(self, other: Any) -> bool:
            return (isinstance(other, Box) and self.shape == other.shape
                    and self.dtype == other.dtype and np.array_equal(self.low, other.low)
                    and np.array_equal(self.high, other.high))

        def __repr__(self) -> str:
            return f"Box({self.low.min(initial=0)}, {self.high.max(initial=0)}, {self.shape}, {self.dtype})"

    class AutoresetMode(enum.Enum):  # type: ignore[no-redef]
        """What becomes of an environment whose episode is over."""

        NEXT_STEP = "NextStep"
        SAME_STEP = "SameStep"
        DISABLED = "Disabled"

    class _Seeded:
        """Random numbers, and the end of a with statement."""

        spec = None
        _np_random: Optional[np.random.Generator] = None
        _np_random_seed: Optional[int] = None

        @property
        def np_random(self) -> np.random.Generator:
            if self._np_random is None:
                self._seed(None)
            assert self._np_random is not None
            return self._np_random

        def _seed(self, seed: Optional[int]) -> None:
            sequence = np.random.SeedSequence(seed)
            self._np_random_seed = sequence.entropy  # type: ignore[assignment]
            self._np_random = np.random.Generator(np.random.PCG64(sequence))

        def reset(self, *, seed: Optional[int] = None,
                  options: Optional[Dict[str, Any]] = None) -> Any:
            del options
            if seed is not None:
                self._seed(seed)

        @property
        def unwrapped(self) -> Any:
            return self

        def close(self, **others: Any) -> None:
            del others
            self.close_extras()

        def close_extras(self, **others: Any) -> None:
            del others

        def __enter__(self) -> Any:
            return self

        def __exit__(self, *reason: Any) -> None:
            self.close()

    class Env(_Seeded):  # type: ignore[no-redef]
        """What gymnasium.Env does."""

    class VectorEnv(_Seeded):  # type: ignore[no-redef]
        """What gymnasium.vector.VectorEnv does."""


def limitless(shape: Tuple[int, ...]) -> Box:
    """Of observations: what a simulation shows is not promised to lie between limits."""
    return Box(-np.inf, np.inf, shape, np.float32)


def unit(shape: Tuple[int, ...]) -> Box:
    """Of actions: -1 to 1."""
    return Box(-1.0, 1.0, shape, np.float32)
