"""The structs of taskc/plugin.h and taskc/host.h, field by field."""

from ctypes import (CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_int32, c_int64, c_ssize_t,
                    c_ubyte, c_uint32, c_uint64, c_void_p)

ABI_VERSION = 5

BOOL, INT, REAL = range(3)
SUCCESS, FAILURE, TRUNCATED = range(3)
(START_OF_EPISODE, END_OF_EPISODE, START_OF_ACTION, END_OF_ACTION, START_OF_TIME_STEP,
 END_OF_TIME_STEP, START_OF_PHYSICS_STEP, END_OF_PHYSICS_STEP, EVENT_COUNT) = range(9)
MEASURE, OBSERVE = 8, 9
FLOAT64, FLOAT32, INT64, INT32, UINT8, BOOL8 = range(6)
WXYZ, XYZW = range(2)

_NAMED = [("name", c_char_p)]
_NAMED_DOC = _NAMED + [("doc", c_char_p)]
_SHAPE = [("scalar", c_int32), ("rows", c_uint32), ("columns", c_uint32)]
_TYPED = [("type", c_char_p), ("unit", c_char_p)] + _SHAPE
_RANGE = [("minimum", c_double), ("maximum", c_double)]


class Place(Structure):
    _fields_ = [("source", c_uint32), ("line", c_uint32)]


class Part(Structure):
    _fields_ = _NAMED


class Sensor(Structure):
    _fields_ = _NAMED_DOC + _TYPED + [("read_by", c_uint32)] + _RANGE


class Param(Structure):
    _fields_ = _NAMED_DOC + [("unit", c_char_p), ("scalar", c_int32), ("initial", c_double)] + _RANGE


class Memory(Structure):
    _fields_ = _NAMED + _TYPED + [("scope", c_int32), ("offset", c_uint32)]


class Goal(Structure):
    _fields_ = _NAMED_DOC + _TYPED + [("offset", c_uint32), ("held_offset", c_uint32),
                                      ("draw_offset", c_uint32)]


class Observation(Structure):
    _fields_ = _NAMED_DOC + _TYPED + [("offset", c_uint32)] + _RANGE


class StartValue(Structure):
    _fields_ = _NAMED + [("rows", c_uint32), ("offset", c_uint32)]


class Source(Structure):
    _fields_ = [("file", c_char_p), ("text", c_char_p)]


class Phase(Structure):
    _fields_ = _NAMED_DOC + [("place", Place)]


class RewardTerm(Structure):
    _fields_ = _NAMED_DOC + [("place", Place)]


class Metric(Structure):
    _fields_ = _NAMED_DOC + [("unit", c_char_p), ("reduction", c_int32)]


class Log(Structure):
    _fields_ = _NAMED_DOC + [("unit", c_char_p), ("reduction", c_int32), ("place", Place)]


class End(Structure):
    _fields_ = [("reason", c_char_p), ("kind", c_int32), ("place", Place)]


class Requirement(Structure):
    _fields_ = [("reason", c_char_p), ("place", Place)]


# Each table, in the order of the pointers and of the counts.
TABLES = [
    ("links", "link_count", Part), ("joints", "joint_count", Part), ("sites", "site_count", Part),
    ("sources", "source_count", Source), ("poses", "pose_count", Part),
    ("start_values", "start_value_count", StartValue), ("sensors", "sensor_count", Sensor),
    ("params", "param_count", Param), ("memory", "memory_count", Memory),
    ("goals", "goal_count", Goal), ("observations", "observation_count", Observation),
    ("phases", "phase_count", Phase), ("terms", "term_count", RewardTerm),
    ("metrics", "metric_count", Metric), ("logs", "log_count", Log), ("ends", "end_count", End),
    ("requirements", "requirement_count", Requirement),
]


class Plugin(Structure):
    _fields_ = ([("abi_version", c_uint32), ("struct_size", c_uint32)]
                + [(name, c_char_p) for name in ("compiler", "name", "doc", "robot", "source_hash")]
                + [(table, POINTER(entry)) for table, _, entry in TABLES]
                + [(count, c_uint32) for _, count, _ in TABLES]
                + [(name, c_uint32) for name in ("memory_size", "observation_size", "phase_offset",
                                                 "phase_time_offset")]
                + [(name, c_void_p) for name in ("initialize", "draw_pose", "draw_start")]
                + [("events", c_void_p * EVENT_COUNT), ("measure", c_void_p), ("observe", c_void_p)])


class View(Structure):
    _fields_ = [("data", c_void_p), ("format", c_int32), ("quaternions", c_int32),
                ("row_stride", c_ssize_t), ("column_stride", c_ssize_t), ("rows", c_uint32),
                ("columns", c_uint32)]


class Column(Structure):
    _fields_ = [("sensor", c_char_p), ("unit", c_char_p), ("view", View),
                ("time_stride", c_ssize_t)]


class Result(Structure):
    _fields_ = [("reward", c_double), ("end", c_int32), ("violation", c_int32), ("fault", c_int32)]


class Recording(Structure):
    _fields_ = [("columns", POINTER(Column)), ("column_count", c_uint32),
                ("begins_with_start", c_int32), ("rows", c_int64), ("time_step", c_double),
                ("seed", c_uint64), ("action_length", c_int64), ("new_actions", c_void_p),
                ("ends_with_action", c_int32), ("rewards", c_void_p), ("term_sums", c_void_p)]


class Evaluation(Structure):
    _fields_ = [("episode_return", c_double), ("time_steps", c_int64), ("fault_count", c_int64),
                ("kind", c_int32), ("end", c_int32), ("violation", c_int32), ("terms", c_void_p),
                ("metrics", c_void_p), ("logs", c_void_p)]


SENSOR_FUNCTION = CFUNCTYPE(None, c_void_p, POINTER(c_ubyte))
