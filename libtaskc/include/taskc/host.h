// libtaskc: runs compiled tasks in any program.
//
// A host opens a plugin that `taskc build` has made, asks what it reads, makes instances of it,
// says where the sensors' numbers are, and tells each instance of the events of an episode:
//
//   taskc_task* task;
//   taskc_instance* instance;
//   if (taskc_open("balance.so", &task) != TASKC_OK) die(taskc_error());
//   taskc_new_instance(task, &instance);
//   taskc_bind(instance, "pole.angle", "rad", (taskc_view){&angle, TASKC_FLOAT64});
//   taskc_start_episode(instance, seed, NULL);
//   while (running) {
//     simulate();
//     taskc_result result;
//     taskc_event(instance, TASKC_END_OF_TIME_STEP, 0.005, &result);
//     reward += result.reward;
//     if (result.end >= 0) break;
//   }
//   taskc_end_episode(instance, TASKC_TRUNCATED, NULL);
//
// docs/hosts.md has more. C11 and C++; every function may be called from any thread.
//
// Errors: what can fail returns a code, TASKC_OK being 0, and has then changed nothing unless it
// says otherwise. taskc_error() is a sentence about what is wrong, with names and the remedy.
//
// Threads: a task is constant and may be used by all threads at once; an instance by one at a time.
//
// Ownership: who makes a task or an instance ends it. What a view points to is the host's, and must
// be there whenever a function is called that reads the sensor. All other pointers that the library
// gives are its own: those of a task live as long as the task, those of an instance as long as the
// instance, with the values that they have after the last call.
//
// Units: SI (m, kg, s, rad). A unit that a host gives is compared with the task's; null: the
// host is sure of it. Quaternions are (w, x, y, z), unless a view says that its are not.
//
// Versions: the number at the end of the library's name is that of the ABI in plugin.h, which says
// what plugins it runs: all that were built for this number, and no other. See docs/hosts.md.
#ifndef TASKC_HOST_H
#define TASKC_HOST_H

#include <stddef.h>
#include <taskc/plugin.h>

#if defined(TASKC_BUILDS_LIBRARY)
#define TASKC_API __attribute__((visibility("default")))
#else
#define TASKC_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

// ---- Errors -------------------------------------------------------------------------------------

typedef taskc_int32 taskc_status;
enum {
  TASKC_OK = 0,
  TASKC_ERROR_READ = 1,        // the file is missing, or cannot be read
  TASKC_ERROR_NOT_A_TASK = 2,  // it is no shared object for this machine, or no compiled task
  TASKC_ERROR_UNSEALED = 3,    // taskc has not built it, and nobody has sealed it: see `taskc seal`
  TASKC_ERROR_DAMAGED = 4,     // it is cut off or changed, or its table makes no sense
  TASKC_ERROR_OTHER_ABI = 5,   // it was built for another version of the ABI
  TASKC_ERROR_UNKNOWN_NAME = 6,  // the task has no such sensor, param, goal, ...
  TASKC_ERROR_WRONG_UNIT = 7,
  TASKC_ERROR_WRONG_TYPE = 8,    // another number of elements, or a format that cannot be one
  TASKC_ERROR_OUT_OF_RANGE = 9,  // a param, a time step or a number that must be within limits
  TASKC_ERROR_NOT_BOUND = 10,    // nobody has said where a sensor's numbers are
  TASKC_ERROR_WRONG_ORDER = 11,  // such as an event outside of an episode
  TASKC_ERROR_NULL = 12,         // a pointer that must not be null is
  TASKC_ERROR_NO_MEMORY = 13
};

// Of the last call in this thread that failed; "" before. Until the next one that does.
TASKC_API const char* taskc_error(void);

// The ABI that this library was built for: TASKC_ABI_VERSION where it fits these headers.
TASKC_API taskc_uint32 taskc_abi_version(void);

// ---- Tasks --------------------------------------------------------------------------------------

typedef struct taskc_task taskc_task;

// Opens a plugin as the trainer does: without an intact seal none of its code is run; what it says
// of itself is checked. Its file may be changed or deleted afterwards.
TASKC_API taskc_status taskc_open(const char* file, taskc_task** task);
// Instances that are left keep the plugin loaded. Null is nothing.
TASKC_API void taskc_close(taskc_task* task);

// All that the task says of itself: what it reads, pays, measures, logs and ends, its params, goals
// and observations, the links, joints and sites of its robot. plugin.h says what each field is. Its
// functions are the library's to call.
TASKC_API const taskc_plugin* taskc_describe(const taskc_task* task);

// ---- Instances ----------------------------------------------------------------------------------

typedef struct taskc_instance taskc_instance;

// Its params have their initial values; its sensors are to be bound.
TASKC_API taskc_status taskc_new_instance(const taskc_task* task, taskc_instance** instance);
// Null is nothing.
TASKC_API void taskc_delete_instance(taskc_instance* instance);

// ---- Sensors ------------------------------------------------------------------------------------

// A robot's `contact` is not the raw contact of an instant: taskc/contact_filter.h makes it.

// How a host has one number in memory. What a task takes as a real may be any of these; as an int,
// any but floats; as a bool, any: it is true where it is not 0.
enum {
  TASKC_FLOAT64 = 0,
  TASKC_FLOAT32 = 1,
  TASKC_INT64 = 2,
  TASKC_INT32 = 3,
  TASKC_UINT8 = 4,
  TASKC_BOOL8 = 5  // one byte that is 0 or 1
};

// In which order a host has the elements of a quaternion.
enum {
  TASKC_WXYZ = 0,  // as tasks, MuJoCo and Eigen's constructor
  TASKC_XYZW = 1   // as ROS, SciPy, PyBullet and newer Isaac Lab
};

// Numbers in a host's memory: a value with rows and columns as in `taskc_sensor`. What has the
// type's own format (FLOAT64 for reals, INT64 for ints, BOOL8 for bools), is aligned and has its
// elements side by side is read where it is; all else is copied before each event that reads it.
typedef struct taskc_view {
  const void* data;
  taskc_int32 format;       // TASKC_FLOAT64 ...
  taskc_int32 quaternions;  // TASKC_WXYZ or TASKC_XYZW; of other types 0
  // From one row, or column, to the next [bytes]; both 0: the elements are side by side.
  ptrdiff_t row_stride;
  ptrdiff_t column_stride;
  // How many the host has, to be compared with the task's; 0: the host is sure of it.
  taskc_uint32 rows;
  taskc_uint32 columns;
} taskc_view;

// Says where a sensor's numbers are: "base.velocity", or one entry of an array, by the name of its
// link, joint or site or by its number: "joint.angle[left_knee]", "contact[0]", which is a row of
// its own. Replaces what was said before. Entries that are bound one by one must all be before the
// first event. Fails with UNKNOWN_NAME, WRONG_UNIT, WRONG_TYPE or NULL.
TASKC_API taskc_status taskc_bind(taskc_instance* instance, const char* sensor, const char* unit,
                                  taskc_view view);

// Writes the elements of a sensor, or of an entry of it, row by row, as the task has them: doubles,
// `taskc_int64`s, or bytes that are 0 or 1. Must not throw, nor call the instance.
typedef void (*taskc_sensor_function)(void* user, void* elements);

// The same with a function that is called before each event that reads the sensor.
TASKC_API taskc_status taskc_bind_function(taskc_instance* instance, const char* sensor,
                                           const char* unit, taskc_sensor_function function,
                                           void* user);

// ---- Params, goals and what the episode starts from ---------------------------------------------

// In SI units. May be set at any time, within its range: OUT_OF_RANGE else, and where the param is
// an int or a bool and the value is none.
TASKC_API taskc_status taskc_set_param(taskc_instance* instance, const char* param,
                                       const char* unit, double value);
TASKC_API taskc_status taskc_get_param(const taskc_instance* instance, const char* param,
                                       double* value);

// What a learner counts the next action's reward for: 0 to 1; at first 1. Read by potentials.
TASKC_API taskc_status taskc_set_discount(taskc_instance* instance, double discount);

// The goal's elements, as many doubles as it has. Held, it has this value and is not drawn, from
// now on and in later episodes, until it is released.
TASKC_API taskc_status taskc_get_goal(taskc_instance* instance, const char* goal, double* elements);
TASKC_API taskc_status taskc_hold_goal(taskc_instance* instance, const char* goal, const char* unit,
                                       const double* elements);
TASKC_API taskc_status taskc_release_goal(taskc_instance* instance, const char* goal);

// For a host that makes the first state. Before taskc_start_episode() with the same seed: draws one
// of the task's poses; null where the task names none. Then the host writes what the pose has into
// the start values, and taskc_draw_start() changes them there (plugin.h says what each means).
// `attempt`: how often it was drawn for this episode before, where the robot could not be so.
TASKC_API taskc_status taskc_draw_pose(taskc_instance* instance, taskc_uint64 seed,
                                       const char** pose);
TASKC_API taskc_status taskc_get_start_value(taskc_instance* instance, const char* name,
                                             double** elements);
TASKC_API taskc_status taskc_draw_start(taskc_instance* instance, taskc_uint32 attempt);

// ---- Events -------------------------------------------------------------------------------------

// What one event has done. Numbers are indices into the task's tables.
typedef struct taskc_result {
  double reward;    // 0 where the sum was not finite, or beyond 1e30
  taskc_int32 end;  // the end that it has reached, as the first event of the episode; or -1
  taskc_int32
      violation;      // the first requirement that did not hold, or -1: the episode is truncated
  taskc_int32 fault;  // the first reward term that could not be paid, or -1
} taskc_result;

// The order of the trainer, in which a task may rely on being called:
//
//   start_episode                          the sensors show the first state
//     START_OF_ACTION                      a learner has decided
//       START_OF_TIME_STEP
//         START_OF_PHYSICS_STEP, END_OF_PHYSICS_STEP, ...
//       END_OF_TIME_STEP, ...              the sensors show the state after it
//     END_OF_ACTION, ...
//   end_episode                            the learner's count is over
//
// An event that the task has nothing to do at costs nothing, and may be left out. A host without
// actions or physics steps of its own leaves those out: what the task does at them is not done
// then. The host ends the episode once an event says that an end was reached or a requirement
// violated: at once, or with the action. `result` may be null.

// Begins an episode; `seed` decides what is drawn in it. What it pays counts for no learner, and is
// not part of taskc_return(). Fails with NOT_BOUND, naming the sensors that are missing.
TASKC_API taskc_status taskc_start_episode(taskc_instance* instance, taskc_uint64 seed,
                                           taskc_result* result);
// `event`: TASKC_START_OF_ACTION ... TASKC_END_OF_PHYSICS_STEP. `time_step`: the length of the time
// step or physics step [s]; 0 for actions. Fails with WRONG_ORDER outside of an episode.
TASKC_API taskc_status taskc_event(taskc_instance* instance, taskc_int32 event, double time_step,
                                   taskc_result* result);
// `outcome`: how it has ended for the learner, TASKC_SUCCESS, TASKC_FAILURE or TASKC_TRUNCATED.
// What the task itself has reached comes first.
TASKC_API taskc_status taskc_end_episode(taskc_instance* instance, taskc_int32 outcome,
                                         taskc_result* result);

// ---- What an episode has come to ----------------------------------------------------------------

// All that was paid since it began.
TASKC_API double taskc_return(const taskc_instance* instance);
// How often something was not paid, as it was not finite or too large.
TASKC_API taskc_int64 taskc_fault_count(const taskc_instance* instance);
// How it has ended, TASKC_SUCCESS, TASKC_FAILURE or TASKC_TRUNCATED, and why; -1 and null while
// nothing has ended it. `reason` may be null.
TASKC_API taskc_int32 taskc_ended(const taskc_instance* instance, const char** reason);
// What each reward term has paid since the episode began: one for each of the table.
TASKC_API const double* taskc_terms(const taskc_instance* instance);
// One for each metric, and one for each log; complete after taskc_end_episode(). Not a number where
// nothing was measured.
TASKC_API const double* taskc_metrics(const taskc_instance* instance);
TASKC_API const double* taskc_logs(const taskc_instance* instance);
// The same by name.
TASKC_API taskc_status taskc_get_term(const taskc_instance* instance, const char* term,
                                      double* value);
TASKC_API taskc_status taskc_get_metric(const taskc_instance* instance, const char* metric,
                                        double* value);
TASKC_API taskc_status taskc_get_log(const taskc_instance* instance, const char* log,
                                     double* value);
// The phase that the task is in: an index into its table; -1 where it has none.
TASKC_API taskc_int32 taskc_present_phase(const taskc_instance* instance);
// What the learner sees now: `observation_size` numbers, 0 where one is not finite. In an episode.
TASKC_API taskc_status taskc_observe(taskc_instance* instance, const double** observations);

// ---- Recorded episodes --------------------------------------------------------------------------

// A sensor, or an entry of one, at each time: like taskc_bind(), with the first row's numbers at
// `view.data` and those of the next `time_stride` bytes further; 0: they never change.
typedef struct taskc_column {
  const char* sensor;
  const char* unit;
  taskc_view view;
  ptrdiff_t time_stride;
} taskc_column;

// A recorded episode. Row k holds the sensors at the end of time step k. `begins_with_start`: its
// first row is the state in which the episode begins, and no time step; otherwise the events at the
// start see the first row, too. In each time step the task is told of all events, a physics step
// being as long as the time step.
typedef struct taskc_recording {
  const taskc_column* columns;
  taskc_uint32 column_count;
  taskc_int32 begins_with_start;  // 0 or 1
  taskc_int64 rows;               // at least 1
  double time_step;               // [s]
  taskc_uint64 seed;
  taskc_int64 action_length;  // an action has so many time steps; 0: one is the whole episode
  const unsigned char*
      new_actions;               // or, for each row, whether one starts with its time step: then
                                 //      `action_length` is not looked at. May be null
  taskc_int32 ends_with_action;  // 1: an episode that is over goes on until the action is, too
  // Out, each may be null: what each row's events have paid, whose sum is the return; and what each
  // term has paid until its end, `term_count` numbers for each row. After the end, 0 and the last.
  double* rewards;
  double* term_sums;
} taskc_recording;

typedef struct taskc_evaluation {
  double episode_return;
  taskc_int64 time_steps;  // until the end
  taskc_int64 fault_count;
  taskc_int32 kind;       // TASKC_SUCCESS ...; TASKC_TRUNCATED where the recording ends
  taskc_int32 end;        // the end that was reached, or -1
  taskc_int32 violation;  // the requirement that did not hold, or -1
  // Out, each may be null: one for each of the table.
  double* terms;
  double* metrics;
  double* logs;
} taskc_evaluation;

// What a task pays for recorded episodes, each for itself and from its beginning, in as many
// threads as `threads` says; 0: one for each processor. The result is the same for any number of
// them. With the params, the discount and the held goals of `instance`, which is not changed. Fails
// as taskc_bind(), with NOT_BOUND and OUT_OF_RANGE, before anything is written.
TASKC_API taskc_status taskc_evaluate(const taskc_instance* instance,
                                      const taskc_recording* recordings, size_t count,
                                      taskc_uint32 threads, taskc_evaluation* evaluations);

#ifdef __cplusplus
}  // extern "C"
#endif

#endif  // TASKC_HOST_H
