"""The libraries by ctypes."""

from __future__ import annotations

import ctypes
from ctypes import (POINTER, byref, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32,
                    c_uint64, c_void_p)
from functools import lru_cache
from typing import Any, Dict, List

from . import _abi
from ._errors import HostError
from ._find import find_library

# What each function takes; those with a status return it, so that call() can look at it.
_FUNCTIONS = {
    "taskc_open": [c_char_p, POINTER(c_void_p)],
    "taskc_new_instance": [c_void_p, POINTER(c_void_p)],
    "taskc_bind": [c_void_p, c_char_p, c_char_p, _abi.View],
    "taskc_bind_function": [c_void_p, c_char_p, c_char_p, _abi.SENSOR_FUNCTION, c_void_p],
    "taskc_set_param": [c_void_p, c_char_p, c_char_p, c_double],
    "taskc_get_param": [c_void_p, c_char_p, POINTER(c_double)],
    "taskc_set_discount": [c_void_p, c_double],
    "taskc_get_goal": [c_void_p, c_char_p, POINTER(c_double)],
    "taskc_hold_goal": [c_void_p, c_char_p, c_char_p, POINTER(c_double)],
    "taskc_release_goal": [c_void_p, c_char_p],
    "taskc_draw_pose": [c_void_p, c_uint64, POINTER(c_char_p)],
    "taskc_get_start_value": [c_void_p, c_char_p, POINTER(POINTER(c_double))],
    "taskc_draw_start": [c_void_p, c_uint32],
    "taskc_start_episode": [c_void_p, c_uint64, POINTER(_abi.Result)],
    "taskc_event": [c_void_p, c_int32, c_double, POINTER(_abi.Result)],
    "taskc_end_episode": [c_void_p, c_int32, POINTER(_abi.Result)],
    "taskc_observe": [c_void_p, POINTER(POINTER(c_double))],
    "taskc_evaluate": [c_void_p, POINTER(_abi.Recording), c_size_t, c_uint32,
                       POINTER(_abi.Evaluation)],
}
_OTHERS = {
    "taskc_error": (c_char_p, []),
    "taskc_abi_version": (c_uint32, []),
    "taskc_close": (None, [c_void_p]),
    "taskc_describe": (POINTER(_abi.Plugin), [c_void_p]),
    "taskc_delete_instance": (None, [c_void_p]),
    "taskc_return": (c_double, [c_void_p]),
    "taskc_fault_count": (c_int64, [c_void_p]),
    "taskc_ended": (c_int32, [c_void_p, POINTER(c_char_p)]),
    "taskc_terms": (POINTER(c_double), [c_void_p]),
    "taskc_metrics": (POINTER(c_double), [c_void_p]),
    "taskc_logs": (POINTER(c_double), [c_void_p]),
    "taskc_present_phase": (c_int32, [c_void_p]),
}


def load(name: str, functions: Dict[str, List[Any]], others: Dict[str, Any], error: str,
         abi_version: str) -> Any:
    """A library, with what its functions take. Those of `functions` return a status, which raises.

    error, abi_version: the functions that say what went wrong, and for which ABI it is.
    """
    try:
        loaded = ctypes.CDLL(find_library(name))
    except OSError as failure:
        raise HostError(0, f"{failure}: install taskc, or set TASKC_HOME to the folder that it was "
                           "installed to, with bin/ and lib/ in it") from None

    def raise_failure(status: int, function: Any, arguments: Any) -> int:
        del function, arguments
        if status != 0:
            raise HostError(status, getattr(loaded, error)().decode())
        return status

    for function_name, arguments in functions.items():
        function = getattr(loaded, function_name)
        function.argtypes = arguments
        function.restype = c_int32
        function.errcheck = raise_failure
    for function_name, (result, arguments) in others.items():
        function = getattr(loaded, function_name)
        function.argtypes = arguments
        function.restype = result
    version = getattr(loaded, abi_version)()
    if version != _abi.ABI_VERSION:
        raise HostError(5, f"the library has ABI {version}, and this package is for "
                           f"{_abi.ABI_VERSION}: install both from one version of taskc")
    return loaded


@lru_cache(maxsize=None)
def library() -> Any:
    """libtaskc, loaded once."""
    return load("libtaskc", _FUNCTIONS, _OTHERS, "taskc_error", "taskc_abi_version")


class Handle:
    """Something that a library has made, ended with this object."""

    def __init__(self, make: Any, end: Any, *arguments: Any):
        self.pointer = c_void_p()
        self._end = end
        make(*arguments, byref(self.pointer))

    def end(self) -> None:
        if getattr(self, "pointer", None):
            self._end(self.pointer)
            self.pointer = c_void_p()

    def __del__(self) -> None:
        self.end()
