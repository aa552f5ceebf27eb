// libtaskc_sim: robots in their tasks as environments, simulated by the trainer's own code.
//
// A program that learns makes environments of a compiled task, resets them, and steps them all at
// once, in several threads:
//
//   taskc_sim_options options;
//   taskc_sim_defaults(&options, sizeof options);
//   options.plugin = "crawling.so";     // taskc build crawling.task
//   options.profile = "fast-tree";
//   options.count = 64;
//   taskc_sim* sim;
//   if (taskc_sim_new(&options, &sim) != TASKC_OK) die(taskc_sim_error());
//   const taskc_sim_description* about = taskc_sim_describe(sim);
//   ...                                 // arrays of about->action_size, about->observation_size
//   taskc_sim_reset(sim, NULL, seeds, observations);
//   while (learning) {
//     decide(observations, actions);
//     taskc_sim_step(sim, actions, &(taskc_sim_arrays){observations, .rewards = rewards, ...});
//   }
//   taskc_sim_delete(sim);
//
// docs/hosts.md has more. C11 and C++.
//
// What an action and an observation are is a matter of the agent, as in the trainer: with `ppo`,
// the default, an action is offsets of the joints' targets from the robot's first pose, -1 to 1
// times its `action_space.scale` [rad], held for `action_space.hold` time steps; no bounds, as
// joints stop where they must. The observation is what the task observes or, where it observes
// nothing, what the robot shows. Environments that are made with the seed S and run the episode
// number N (taskc_sim_reset) pay, bit for bit, what the trainer pays for the same actions in
// episode N of a run with the seed S, as far as the task keeps nothing from one episode to the
// next.
//
// Errors: what can fail returns a code, TASKC_OK being 0. taskc_sim_error() is a sentence about
// what is wrong, with names and the remedy. Null where there must be a pointer is TASKC_ERROR_NULL.
//
// Threads: a `taskc_sim` belongs to one thread at a time, and has threads of its own for its
// environments; the numbers are the same for any number of them. It does not survive fork().
//
// Ownership: who makes a `taskc_sim` deletes it. Arrays are the caller's; all other pointers that
// the library gives are its own, and valid as long as the `taskc_sim` unless said otherwise.
//
// Units: SI (m, kg, s, rad).
//
// Versions: the number at the end of the library's name is that of the ABI in plugin.h, as
// libtaskc's. Within a number functions are added, and fields at the end of taskc_sim_options and
// taskc_sim_description; nothing else changes.
#ifndef TASKC_SIM_H
#define TASKC_SIM_H

#include <stddef.h>
#include <taskc/host.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---- Errors -------------------------------------------------------------------------------------

// Beside those of host.h, which say what is wrong with a plugin.
enum {
  TASKC_SIM_ERROR_SETUP = 101,   // task, robot, profile, agent or a setting is not there, or does
                                 // not fit the others
  TASKC_SIM_ERROR_EPISODE = 102  // an episode cannot begin, or the environment cannot go on
};

// Of the last call in this thread that failed; "" before. Until the next one that does.
TASKC_API const char* taskc_sim_error(void);

// The ABI that this library was built for: TASKC_ABI_VERSION where it fits these headers.
TASKC_API taskc_uint32 taskc_sim_abi_version(void);

// ---- Environments -------------------------------------------------------------------------------

// What becomes of an environment whose episode is over (the modes of Gymnasium's AutoresetMode):
enum {
  TASKC_SIM_NEXT_STEP = 0,  // the next step begins another one: it ignores the action, pays 0
  TASKC_SIM_SAME_STEP = 1,  // another one begins at once: the observation is its first
  TASKC_SIM_DISABLED = 2    // the caller resets it before the next step
};

typedef struct taskc_sim_options {
  size_t struct_size;  // as taskc_sim_defaults() was told
  // Built by `taskc build`. Required.
  const char* plugin;
  // The task's file, NAME.task: what stands beside it for its agents, NAME.agent.toml and
  // NAME.AGENT.agent.toml, counts as in the trainer. Null: beside the plugin.
  const char* task;
  const char* robot;    // of a task that names none; null: the task's own
  const char* robots;   // folder in which robots are looked for first; null: none
  const char* agent;    // one of the robot's agents, or a file; default "ppo"
  const char* profile;  // how to simulate, "paper" ... "mujoco"; null: as the agent says
  // MODULE.PARAMETER=VALUE each, as `trainer train --set`: params of the task, what is random in
  // the simulation, how long a decision lasts.
  const char* const* settings;
  size_t setting_count;
  taskc_uint64 seed;      // of the run; default 0
  double discount;        // of the learner, read by potentials: 0 to 1; default 0.99
  taskc_uint32 count;     // of environments; default 1
  taskc_uint32 threads;   // that step them; 0, the default: one for each processor
  taskc_int32 autoreset;  // TASKC_SIM_NEXT_STEP, the default, ...
} taskc_sim_options;

// `size`: of the struct as the caller knows it, which is what a later library goes by.
TASKC_API void taskc_sim_defaults(taskc_sim_options* options, size_t size);

typedef struct taskc_sim taskc_sim;

// Fails as taskc_open(), with TASKC_SIM_ERROR_SETUP, and with OUT_OF_RANGE for numbers that must be
// within limits. The plugin's file may be changed or deleted afterwards.
TASKC_API taskc_status taskc_sim_new(const taskc_sim_options* options, taskc_sim** sim);
// Null is nothing.
TASKC_API void taskc_sim_delete(taskc_sim* sim);

// Some of the numbers of an observation, one after the other.
typedef struct taskc_sim_observation {
  const char* name;
  const char* type;  // as in the task: "vec3", "real[joint]"
  const char* unit;  // "m/s"; "" for a plain number
  taskc_uint32 size;
  double minimum;  // of each number; infinite where nothing is known
  double maximum;
} taskc_sim_observation;

typedef struct taskc_sim_description {
  const taskc_plugin* task;  // plugin.h: names of terms, metrics, logs, ...
  const char* robot;         // "" where the task has none
  const char* profile;       // "" without a choice
  double time_step;          // [s]
  double decision_time;      // how long an action lasts at first [s]; 0 where that differs
  taskc_uint32 count;        // of environments
  taskc_uint32 threads;      // that step them
  taskc_uint32 action_size;
  taskc_uint32 observation_size;
  taskc_uint32 observation_count;
  const taskc_sim_observation* observations;
} taskc_sim_description;

TASKC_API const taskc_sim_description* taskc_sim_describe(const taskc_sim* sim);

// ---- Episodes -----------------------------------------------------------------------------------

// Begins an episode in each environment, or in those for which `which` is not 0; an episode that
// runs is given up. `seeds`: null, or one for each environment, of which the lower 53 bits count:
// with the seed K it is the episode number K + 1 of the run. Without, an environment goes on from
// its last one, in steps of `count`, so that no two have the same: the first ones are 1, 2, 3, ...
// `observations`: [count][observation_size], written for those that begin; may be null.
// Fails with TASKC_SIM_ERROR_EPISODE where an episode ends where it begins: no start could be found
// without links in each other, say. The environments that failed are then to be reset again.
TASKC_API taskc_status taskc_sim_reset(taskc_sim* sim, const unsigned char* which,
                                       const taskc_uint64* seeds, float* observations);

// What a step writes, one row for each environment. Each may be null.
typedef struct taskc_sim_arrays {
  float* observations;  // [count][observation_size]
  // [count][observation_size]; of those whose episode ends in this step: what is seen last. Where
  // another one begins at once `observations` has that one's.
  float* final_observations;
  double* rewards;            // [count]: of the action
  unsigned char* terminated;  // [count]: 1 where the task has succeeded or failed, else 0
  unsigned char* truncated;   // [count]: 1 where the episode ends for another reason, else 0
  double* term_sums;    // [count][term_count]: what each term has paid in the episode that the
                        // reward is of
  taskc_uint32* ended;  // one number: in how many environments an episode has ended
} taskc_sim_arrays;

// A decision in each environment: `actions` [count][action_size]. Fails with OUT_OF_RANGE for one
// that is not a number, before anything is stepped; with WRONG_ORDER where an environment must be
// reset first; with TASKC_SIM_ERROR_EPISODE where another episode cannot begin or go on: all
// environments are then to be reset.
TASKC_API taskc_status taskc_sim_step(taskc_sim* sim, const float* actions,
                                      const taskc_sim_arrays* arrays);

enum {
  TASKC_SIM_DIVERGED = 3
};  // kind of an end, beside TASKC_SUCCESS ...: not to be learned from

// An episode that is over.
typedef struct taskc_sim_episode {
  taskc_int64 number;  // in the run
  taskc_int64 actions;
  taskc_int64 time_steps;
  double seconds;  // of the robot's time
  double episode_return;
  taskc_int32 kind;         // TASKC_SUCCESS, TASKC_FAILURE, TASKC_TRUNCATED or TASKC_SIM_DIVERGED
  const char* reason;       // "is on the hill"
  taskc_int64 fault_count;  // how often something was not paid, as it was not finite or too large
  const double* terms;      // one for each of the task's table
  const double* metrics;    // not a number where nothing was measured
  const double* logs;
} taskc_sim_episode;

// The one that has ended last in this environment. Its pointers are valid until the next step or
// reset. Fails with WRONG_ORDER where none has, with OUT_OF_RANGE where there is no such
// environment.
TASKC_API taskc_status taskc_sim_last_episode(const taskc_sim* sim, taskc_uint32 environment,
                                              taskc_sim_episode* episode);

// The episodes that have ended in the last step, in columns: one number for each environment, 0
// where none has ended. Each may be null.
typedef struct taskc_sim_ends {
  taskc_int64* numbers;  // as in taskc_sim_episode
  taskc_int32* kinds;    // -1 where none has ended
  const char** reasons;  // null where none has ended; valid until the next step or reset
  double* returns;
  double* seconds;
  double* terms;    // [term_count][count]
  double* metrics;  // [metric_count][count]
  double* logs;     // [log_count][count]
} taskc_sim_ends;

TASKC_API taskc_status taskc_sim_last_ends(const taskc_sim* sim, const taskc_sim_ends* ends);

// ---- Parameters ---------------------------------------------------------------------------------

// Sets a parameter of a module, "task.weight", in each environment, or in those for which `which`
// is not 0: from the next decision on, and in all later episodes. `value`: as in `settings`; a
// number may also have its unit, "20 s". Fails with TASKC_SIM_ERROR_SETUP, and changes nothing,
// where there is no such parameter, where it has no effect any more (a profile, say), and for a
// value of another type or unit or out of its range.
TASKC_API taskc_status taskc_sim_set(taskc_sim* sim, const unsigned char* which,
                                     const char* parameter, const char* value);

// ---- Pictures -----------------------------------------------------------------------------------

// Draws the robot of an environment as it is now, and the things around it: `size` by `size` pixels
// of red, green and blue, the top row first. The camera goes along with the robot. Fails with
// WRONG_ORDER before an episode, with OUT_OF_RANGE for a size that is not from 16 to 4096, and with
// TASKC_SIM_ERROR_SETUP where there is no robot.
TASKC_API taskc_status taskc_sim_render(taskc_sim* sim, taskc_uint32 environment, taskc_uint32 size,
                                        unsigned char* rgb);

#ifdef __cplusplus
}  // extern "C"
#endif

#endif  // TASKC_SIM_H
