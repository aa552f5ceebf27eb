// The contract between a compiled task and the program that runs it.
//
// `taskc` turns a `.task` file into a shared object that exports one function, `taskc_plugin_get`.
// It returns a description of the task (what it reads, remembers, pays and measures) and one
// function per event. Everything here is plain C: a host in any language can use it.
//
// Ownership: the plugin owns the `taskc_plugin` and all it points to; they are constant and live as
// long as the shared object is loaded. The host owns every `taskc_frame` and all it points to. A
// plugin has no state of its own, so any number of instances can run side by side, one frame each.
//
// Order of calls: for each frame, `initialize` once, when the params are set and before all else;
// then, in each episode, `start_of_episode`, the other events as they happen, `end_of_episode`.
// `measure` follows `end_of_time_step`, and once more `end_of_episode`. `observe` may be called
// between any two of these calls, `start_of_episode` being the first of the episode: whenever the
// learner decides, which is when no callback of that moment is left to call. It changes nothing but
// `observations`. A function that is null has nothing to do. The functions themselves reset memory:
// `start_of_episode` all but that of the run, `start_of_action` that of the action, to initial
// values that may be params; the host never does.
//
// Before `start_of_episode`, a host that makes the first state draws it as the task says: it sets
// `taskc_frame.seed` and `attempt = 0`, calls `draw_pose` (null: the first pose counts), puts the
// values of that pose into the memory block where `start_values` say, calls `draw_start`, and takes
// the values from there. If nothing can be in that state, such as links inside each other, the host
// may draw another one: it adds 1 to `attempt`, puts the values of the same pose into the memory
// block again, and calls `draw_start`; the goals stay what they are. The two functions take nothing
// from the memory of an episode that runs, and what they draw depends on the seed, the attempt, the
// params and the memory of the run alone.
//
// Pointers: where a count is 0, the pointer that belongs to it is null in a `taskc_plugin` and may
// be null in a `taskc_frame`; likewise `memory` where `memory_size` is 0.
//
// Units: SI throughout (m, kg, s, rad). Matrices are row major, quaternions are (w, x, y, z).
//
// Stability: `abi_version` is the first field of `taskc_plugin` in every version, and a host
// refuses a version it was not built for. Any change of a struct or of a meaning raises
// TASKC_ABI_VERSION.
#ifndef TASKC_PLUGIN_H
#define TASKC_PLUGIN_H

#define TASKC_ABI_VERSION 5u
#define TASKC_PLUGIN_ENTRY "taskc_plugin_get"

#ifdef __cplusplus
extern "C" {
#endif

typedef int taskc_int32;
typedef unsigned int taskc_uint32;
typedef long long taskc_int64;
typedef unsigned long long taskc_uint64;

// The moments at which a task computes. In a time step the controller's
// targets change once (every 5 ms for the humanoid); a physics step is one step of the simulator.
enum {
  TASKC_START_OF_EPISODE,
  TASKC_END_OF_EPISODE,
  TASKC_START_OF_ACTION,
  TASKC_END_OF_ACTION,
  TASKC_START_OF_TIME_STEP,
  TASKC_END_OF_TIME_STEP,
  TASKC_START_OF_PHYSICS_STEP,
  TASKC_END_OF_PHYSICS_STEP,
  TASKC_EVENT_COUNT
};

// Of the events that follow an end, a task may rely on this: the first callback that reaches an
// end, or in which a requirement does not hold, is the last of its episode that does anything.
// Until `start_of_episode` begins anew, each other event function but `end_of_episode` returns at
// once: it pays nothing, reaches no end and changes no memory, whether the host calls it for the
// rest of an action or not. The functions see to this themselves, by a variable in the memory
// block. `measure` always measures. A task that says `after_end continue` has no such variable; its
// functions do the same after an end as before.

// Besides the events: the evaluation of the metrics, and of what the learner sees. Used as bit
// numbers in `taskc_sensor.read_by`.
enum { TASKC_MEASURE = TASKC_EVENT_COUNT, TASKC_OBSERVE, TASKC_READER_COUNT };

// How one scalar lies in memory: a bool is one byte (0 or 1), an int 8 bytes, a real a double.
enum { TASKC_BOOL, TASKC_INT, TASKC_REAL };

// A link, a joint or a site of the robot that the task is for. Their order is that of the entries
// of what has one for each link, joint or site: of a sensor "real[joint]", say.
typedef struct taskc_part {
  const char* name;
} taskc_part;

// A sensor that the task reads: one of the robot's, or one that the task declares itself, of which
// the host alone knows what fills it. `rows * columns` contiguous elements: those of a matrix row
// by row; of an array one row for each entry, so that "vec3[link]" has three columns.
typedef struct taskc_sensor {
  const char* name;      // as the task writes it: "base.velocity"
  const char* doc;       // what it is, of a robot's with its frame
  const char* type;      // as the task writes it: "vec3", "bool[link]"; compared when binding
  const char* unit;      // "m/s"; "" for a plain number
  taskc_int32 scalar;    // TASKC_BOOL, TASKC_INT or TASKC_REAL
  taskc_uint32 rows;     // 1 for a scalar, n for vectors, arrays and quaternions
  taskc_uint32 columns;  // 1 except for matrices
  taskc_uint32 read_by;  // bit e is set: event e (or TASKC_MEASURE, TASKC_OBSERVE) reads the sensor
  double minimum;        // of each element, as the task or the robot says; infinite where they say
  double maximum;        //      nothing
} taskc_sensor;

// A number that can be set while the task runs. Passed as a double, whatever its type.
typedef struct taskc_param {
  const char* name;
  const char* doc;
  const char* unit;
  taskc_int32 scalar;
  double initial;
  double minimum;  // -infinity where the task gives no range
  double maximum;
} taskc_param;

enum { TASKC_PER_RUN, TASKC_PER_EPISODE, TASKC_PER_ACTION };

// A variable in the instance's memory block.
typedef struct taskc_memory {
  const char* name;
  const char* type;
  const char* unit;
  taskc_int32 scalar;
  taskc_uint32 rows;
  taskc_uint32 columns;
  taskc_int32 scope;    // TASKC_PER_RUN, TASKC_PER_EPISODE or TASKC_PER_ACTION
  taskc_uint32 offset;  // bytes from the start of the memory block
} taskc_memory;

// What the robot is told to do: drawn at random by the plugin, or set by the host. Its value,
// whether the host holds it and how often it was drawn in this episode lie in the memory block.
//
// Each draw takes its numbers from Philox4x32-10 (J. Salmon and others, "Parallel random numbers:
// as easy as 1, 2, 3", 2011): its key is `taskc_frame.seed`, its counter (how often this goal was
// drawn before in this episode; the element; the number of the random number in the
// goal's equation; the FNV-1a hash of the goal's name). So equal seeds give equal goals, in every
// host and whatever else a task draws.
typedef struct taskc_goal {
  const char* name;
  const char* doc;
  const char* type;
  const char* unit;
  taskc_int32 scalar;
  taskc_uint32 rows;
  taskc_uint32 columns;
  taskc_uint32 offset;       // of its value: bytes from the start of the memory block
  taskc_uint32 held_offset;  // of a bool: while it is 1 the plugin does not draw the goal
  taskc_uint32 draw_offset;  // of an int: how often the goal was drawn in this episode
} taskc_goal;

// What the learner sees: `rows * columns` numbers of all that `observe` writes, row by row, from
// `offset` on. Each is a double, whatever the value's own type: a bool is 0 or 1. A value that is
// not finite is passed on as it is.
typedef struct taskc_observation {
  const char* name;  // as the task gives it, or the text of the value: "joint.angle - joint.rest"
  const char* doc;
  const char* type;
  const char* unit;
  taskc_int32 scalar;  // of the task's own value
  taskc_uint32 rows;
  taskc_uint32 columns;
  taskc_uint32 offset;  // of its first number: doubles from the start of `taskc_frame.observations`
  double minimum;       // of each of its numbers, as far as it follows from the ranges of what it
  double maximum;       //      depends on; infinite where they say nothing
} taskc_observation;

// A pose of the robot in which an episode may begin, each as likely.
typedef struct taskc_pose {
  const char* name;
} taskc_pose;

// Something of the first state that `draw_start` changes, as doubles in the memory block:
//   "joint.angle", "joint.velocity"           one for each joint [rad], [rad/s]
//   "base.position"                           x, y, z [m]; z is a height above what touches the
//                                             ground: the host lifts or lowers the robot so that it
//                                             touches the ground as in the pose, and then lifts it
//                                             by what z has grown
//   "base.roll", "base.pitch", "base.yaw"     the robot is turned by these about the world's x,
//                                             then y, then z axis [rad]; before, 0
//   "base.velocity", "base.angular_velocity"  x, y, z in the world [m/s], [rad/s]
// What the task does not list stays as in the pose, at rest.
typedef struct taskc_start_value {
  const char* name;
  taskc_uint32 rows;
  taskc_uint32 offset;  // bytes from the start of the memory block
} taskc_start_value;

// One of the texts that a task is made of.
typedef struct taskc_source {
  const char* file;  // as it was named when the task was built
  const char* text;  // the whole text
} taskc_source;

// A place in these texts.
typedef struct taskc_place {
  taskc_uint32 source;  // index into `taskc_plugin.sources`
  taskc_uint32 line;    // from 1
} taskc_place;

// A phase of a task: a stretch of an episode with rewards and rules of its own.
typedef struct taskc_phase {
  const char* name;
  const char* doc;
  taskc_place place;
} taskc_phase;

// A named part of the reward. The terms that the task calls potentials (A. Ng and others, "Policy
// invariance under reward transformations", 1999) pay discount * phi(s') - phi(s) for each action,
// at `end_of_action`, or at `end_of_episode` where that comes first; phi is 0 at a terminal end. So
// what they pay for an episode that ends in a terminal way, each action discounted, is -phi of its
// first state.
typedef struct taskc_reward_term {
  const char* name;
  const char* doc;
  taskc_place place;  // of its first statement
} taskc_reward_term;

enum { TASKC_LAST, TASKC_SUM, TASKC_MAX, TASKC_MIN, TASKC_MEAN };

// What the user really wants: one number per episode, reduced over its time steps.
typedef struct taskc_metric {
  const char* name;
  const char* doc;
  const char* unit;
  taskc_int32 reduction;  // TASKC_LAST ... TASKC_MEAN
} taskc_metric;

// Something worth a curve: one number per episode, reduced over the times that its statements ran.
typedef struct taskc_log {
  const char* name;
  const char* doc;
  const char* unit;
  taskc_int32 reduction;  // TASKC_LAST ... TASKC_MEAN
  taskc_place place;      // of its first statement
} taskc_log;

// What has been logged since the host zeroed it, which it does when an episode starts. While
// `count` is 0, `last`, `minimum` and `maximum` mean nothing. A value that is not a number stays in
// `sum`, `minimum` and `maximum`.
typedef struct taskc_log_state {
  taskc_int64 count;
  double last;
  double sum;
  double minimum;
  double maximum;
} taskc_log_state;

// Something that the task takes for granted. Where it does not hold the callback continues, and
// what it pays counts; but the host ends the episode there, as truncated, whatever end the callback
// reached.
typedef struct taskc_requirement {
  const char* reason;  // as the task words it, or else the condition itself
  taskc_place place;
} taskc_requirement;

enum { TASKC_SUCCESS, TASKC_FAILURE, TASKC_TRUNCATED };

// One statement that ends an episode.
typedef struct taskc_end {
  const char* reason;
  taskc_int32 kind;  // success and failure are terminal; truncated is a mere limit
  taskc_place place;
} taskc_end;

// All that an event function reads and writes. The host fills it once when it binds the task, and
// before each call sets `time_step`, `reward = 0`, `end = -1`, `fault = -1` and `violation = -1`.
typedef struct taskc_frame {
  const void* const* sensors;  // one pointer for each entry of `taskc_plugin.sensors`
  const double* params;        // one value for each entry of `taskc_plugin.params`
  void* memory;                // `memory_size` bytes, aligned to 16
  taskc_uint64 seed;           // of goals and start: another one in each episode
  taskc_int32 pose;            // out, of `draw_pose`: index into `taskc_plugin.poses`
  taskc_uint32 attempt;        // for `draw_start`: how often it was called for this episode before
  double time_step;            // length of the step that ends or starts [s]; 0 for other events;
                               //      for `measure`, that of the last time step
  double discount;             // of the learner, for one action: 0 to 1; 1 where nobody learns.
                               //      Read by `end_of_action` and `end_of_episode`
  taskc_int32 outcome;         // for `end_of_episode`: how the episode has ended for the learner,
                               //      TASKC_SUCCESS, TASKC_FAILURE or TASKC_TRUNCATED
  double* terms;               // one sum for each reward term: the plugin adds, the host zeroes
  double* metrics;             // one value for each metric: written by `measure`, which leaves
                               //      the fields marked `out` alone
  double* observations;        // `observation_size` numbers: written by `observe`, and by nothing
                               //      else; may be null where that is never called
  taskc_log_state* logs;       // one for each log: the plugin adds to it
  double reward;               // out: what this call pays
  taskc_int32 end;             // out: index of the first end that was reached, or -1
  taskc_int32 fault;           // out: index of the first term whose value was not finite, or -1;
                               //      such a value is not paid
  taskc_int32 violation;       // out: index of the first requirement that did not hold, or -1
} taskc_frame;

typedef void (*taskc_event_function)(taskc_frame* frame);

typedef struct taskc_plugin {
  taskc_uint32 abi_version;  // TASKC_ABI_VERSION
  taskc_uint32 struct_size;  // sizeof(taskc_plugin)
  const char* compiler;      // "taskc 0.1.0"
  const char* name;
  const char* doc;
  const char* robot;        // "" where the task declares its own sensors
  const char* source_hash;  // SHA-256 of the text, in hexadecimal; of several texts: the SHA-256 of
                            // their hashes, concatenated

  const taskc_part* links;  // of the robot
  const taskc_part* joints;
  const taskc_part* sites;
  const taskc_source* sources;  // the task's own text first, then those that it refers to
  const taskc_pose* poses;
  const taskc_start_value* start_values;
  const taskc_sensor* sensors;
  const taskc_param* params;
  const taskc_memory* memory;
  const taskc_goal* goals;
  const taskc_observation* observations;
  const taskc_phase* phases;  // an episode begins in the first
  const taskc_reward_term* terms;
  const taskc_metric* metrics;
  const taskc_log* logs;
  const taskc_end* ends;
  const taskc_requirement* requirements;
  taskc_uint32 link_count;  // 0 where the task is for no robot
  taskc_uint32 joint_count;
  taskc_uint32 site_count;
  taskc_uint32 source_count;  // at least 1
  taskc_uint32 pose_count;    // 0 where the task names none: the robot's first
  taskc_uint32 start_value_count;
  taskc_uint32 sensor_count;
  taskc_uint32 param_count;
  taskc_uint32 memory_count;
  taskc_uint32 goal_count;
  taskc_uint32 observation_count;
  taskc_uint32 phase_count;
  taskc_uint32 term_count;
  taskc_uint32 metric_count;
  taskc_uint32 log_count;
  taskc_uint32 end_count;
  taskc_uint32 requirement_count;
  taskc_uint32 memory_size;       // bytes; 0 where the task remembers nothing
  taskc_uint32 observation_size;  // numbers; 0 where the task observes nothing
  // Where in the memory block the phases lie; 0 where there are none.
  taskc_uint32 phase_offset;       // of an int: the number of the present one, from 0
  taskc_uint32 phase_time_offset;  // of a real: how long it has been the present one [s]

  taskc_event_function initialize;  // gives all memory its initial value, draws the goals
  taskc_event_function draw_pose;   // null where there is nothing to draw
  taskc_event_function draw_start;  // null where the pose stays as it is
  taskc_event_function events[TASKC_EVENT_COUNT];  // null where there is nothing to do or reset
  taskc_event_function measure;                    // null where the task has no metric
  taskc_event_function observe;                    // null where the task observes nothing
} taskc_plugin;

// The one exported symbol. Never returns null.
typedef const taskc_plugin* (*taskc_plugin_entry)(void);

#ifdef __cplusplus
}  // extern "C"
#endif

#endif  // TASKC_PLUGIN_H
