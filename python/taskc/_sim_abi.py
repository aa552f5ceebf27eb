"""The structs of taskc/sim.h, field by field, and its functions."""

from __future__ import annotations

from ctypes import (POINTER, Structure, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32,
                    c_uint64, c_void_p)
from functools import lru_cache
from typing import Any

from . import _abi
from ._library import load

NEXT_STEP, SAME_STEP, DISABLED = range(3)


class Options(Structure):
    _fields_ = [("struct_size", c_size_t), ("plugin", c_char_p), ("task", c_char_p),
                ("robot", c_char_p), ("robots", c_char_p), ("agent", c_char_p),
                ("profile", c_char_p), ("settings", POINTER(c_char_p)), ("setting_count", c_size_t),
                ("seed", c_uint64), ("discount", c_double), ("count", c_uint32),
                ("threads", c_uint32), ("autoreset", c_int32)]


class Observation(Structure):
    _fields_ = [("name", c_char_p), ("type", c_char_p), ("unit", c_char_p), ("size", c_uint32),
                ("minimum", c_double), ("maximum", c_double)]


class Description(Structure):
    _fields_ = [("task", POINTER(_abi.Plugin)), ("robot", c_char_p), ("profile", c_char_p),
                ("time_step", c_double), ("decision_time", c_double), ("count", c_uint32),
                ("threads", c_uint32), ("action_size", c_uint32), ("observation_size", c_uint32),
                ("observation_count", c_uint32), ("observations", POINTER(Observation))]


class Arrays(Structure):
    _fields_ = [(name, c_void_p) for name in ("observations", "final_observations", "rewards",
                                              "terminated", "truncated", "term_sums",
                                              "ended")]


class Episode(Structure):
    _fields_ = [("number", c_int64), ("actions", c_int64), ("time_steps", c_int64),
                ("seconds", c_double), ("episode_return", c_double), ("kind", c_int32),
                ("reason", c_char_p), ("fault_count", c_int64), ("terms", POINTER(c_double)),
                ("metrics", POINTER(c_double)), ("logs", POINTER(c_double))]


class Ends(Structure):
    _fields_ = [(name, c_void_p) for name in ("numbers", "kinds", "reasons", "returns", "seconds",
                                              "terms", "metrics", "logs")]


_FUNCTIONS = {
    "taskc_sim_new": [POINTER(Options), POINTER(c_void_p)],
    "taskc_sim_reset": [c_void_p, c_void_p, c_void_p, c_void_p],
    "taskc_sim_step": [c_void_p, c_void_p, POINTER(Arrays)],
    "taskc_sim_set": [c_void_p, c_void_p, c_char_p, c_char_p],
    "taskc_sim_last_episode": [c_void_p, c_uint32, POINTER(Episode)],
    "taskc_sim_last_ends": [c_void_p, POINTER(Ends)],
    "taskc_sim_render": [c_void_p, c_uint32, c_uint32, c_void_p],
}
_OTHERS = {
    "taskc_sim_error": (c_char_p, []),
    "taskc_sim_abi_version": (c_uint32, []),
    "taskc_sim_defaults": (None, [POINTER(Options), c_size_t]),
    "taskc_sim_delete": (None, [c_void_p]),
    "taskc_sim_describe": (POINTER(Description), [c_void_p]),
}


@lru_cache(maxsize=None)
def library() -> Any:
    """libtaskc_sim, loaded once."""
    return load("libtaskc_sim", _FUNCTIONS, _OTHERS, "taskc_sim_error", "taskc_sim_abi_version")
