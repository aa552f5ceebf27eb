"""NumPy arrays as the library reads them: where they are, wherever that is possible."""

from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

import numpy as np

from . import _abi
from ._describe import Sensor

_FORMATS = {
    np.dtype(np.float64): _abi.FLOAT64, np.dtype(np.float32): _abi.FLOAT32,
    np.dtype(np.int64): _abi.INT64, np.dtype(np.int32): _abi.INT32,
    np.dtype(np.uint8): _abi.UINT8, np.dtype(np.bool_): _abi.BOOL8,
}


class Quaternions:
    """Quaternions whose elements are in the order (x, y, z, w); see xyzw()."""

    def __init__(self, array: Any):
        self.array = np.asarray(array)


def xyzw(array: Any) -> Quaternions:
    """Says that quaternions are in the order (x, y, z, w), as ROS, SciPy and PyBullet have them.

    Without it they are taken to be (w, x, y, z), as tasks and MuJoCo have them.
    """
    return Quaternions(array)


def find(sensors: Dict[str, Sensor], name: str) -> "Optional[Tuple[Sensor, Tuple[int, ...]]]":
    """The sensor, and the shape of what `name` stands for: of an entry "joint.angle[knee]" that
    without the first axis. None where the task reads no such sensor."""
    if name in sensors:
        return sensors[name], sensors[name].shape
    whole = sensors.get(name.split("[", 1)[0])
    if whole is None or not name.endswith("]") or not whole.is_array:
        return None
    return whole, whole.shape[1:]


def of_format(value: Any) -> "Tuple[np.ndarray, int]":
    """The value as an array with one of the library's formats, and whether it is (x, y, z, w)."""
    is_xyzw = isinstance(value, Quaternions)
    array = value.array if is_xyzw else np.asarray(value)
    if array.dtype not in _FORMATS:
        kind = array.dtype.kind
        if kind not in "fiub":
            raise TypeError(f"an array of {array.dtype} holds no numbers")
        array = array.astype(np.float64 if kind == "f" else np.int64)
    if any(stride == 0 and size > 1 for stride, size in zip(array.strides, array.shape)):
        array = array.copy()  # 0 would mean that the elements are side by side
    return array, _abi.XYZW if is_xyzw else _abi.WXYZ


def view(sensor: Sensor, name: str, shape: Tuple[int, ...], array: np.ndarray,
         quaternions: int, axes: int = 0) -> _abi.View:
    """How the library sees `array`, whose first `axes` axes are times."""
    if array.shape[axes:] != shape:
        raise ValueError(f"the sensor `{name}` has the shape {shape} in `{sensor.unit or 'plain numbers'}`"
                         f", and the array has {array.shape[axes:]}")
    strides = array.strides[axes:]
    is_row = name != sensor.name  # an entry: its elements are columns
    row, column = (0, strides[0] if strides else 0) if is_row else (tuple(strides) + (0, 0))[:2]
    return _abi.View(data=array.ctypes.data, format=_FORMATS[array.dtype], quaternions=quaternions,
                     row_stride=row, column_stride=column)
