// What is stored about a run, as plain values. SI units throughout.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/core/module/values.h"
#include "runtime/core/task/task_goals.h"
#include "runtime/core/task/task_phases.h"
#include "runtime/training/run/change.h"

namespace runtime {

enum class RunState { kRunning, kInterrupted, kFinished };

std::string_view RunStateName(RunState state);  // "running"

struct TermRecord {
  std::string name;
  std::string doc;
};

struct SourceRecord {
  std::string file;
  std::string text;
};

struct GoalRecord {
  std::string name;
  std::string type;  // "vec2"
  std::string unit;
  std::string doc;
};

struct PhaseRecord {
  std::string name;
  std::string doc;
};

// A metric, a log, or what a learner shows of itself: one number per episode.
struct CurveRecord {
  std::string name;
  std::string unit;
  std::string reduction;  // "last", "sum", "max", "min", "mean"; "" for the learner's
  std::string doc;
};

// A plugin that was loaded in a run under a module's name.
struct TaskRecord {
  int64_t id = 0;      // from 1, in the order of loading; 1 is the task that the run began with
  std::string module;  // name of the task module: "task"
  std::string task;
  std::string task_file;
  std::string task_hash;  // SHA-256 of the sources
  std::string plugin;     // file name of the shared object in the run's folder
  std::string compiler;
  std::vector<TermRecord> terms;
  std::vector<CurveRecord> metrics;
  std::vector<CurveRecord> logs;
  std::vector<GoalRecord> goals;
  std::vector<PhaseRecord> phases;
  std::vector<SourceRecord> sources;  // the task's own first
};

// What makes a run what it is: with it, the plugins' files, the changes and the last checkpoint a
// run goes on.
struct RunRecord {
  std::string robot;
  std::string robot_description;  // text of the robot's file
  std::string agent;              // resolved agent file, TOML
  std::string profile;
  std::string version;   // of the trainer
  std::string body;      // links' names and shapes, JSON
  std::string settings;  // what the user set in the agent and the task, JSON (run_settings.h)
  std::string call;      // of `trainer train`, without what stands here besides, JSON
  uint64_t seed = 0;
  int64_t episodes_planned = 0;
  int64_t record_every = 0;       // 0: only the best episodes and the last
  double checkpoint_seconds = 0;  // at most one checkpoint in this time
  std::vector<TaskRecord> tasks;  // by their ids, so that the first is the one at the start
};

// The task with this id, which the run must have.
const TaskRecord& TaskWithId(const RunRecord& run, int64_t id);
// "crawling (a1b2c3d4)"
std::string VersionText(const TaskRecord& task);
// Whether the two are of one text. Their files may differ: the text's own path is part of them.
bool IsSameVersion(const TaskRecord& a, const TaskRecord& b);

// What one task says of one episode.
struct Evaluation {
  int64_t task = 0;  // TaskRecord::id
  double episode_return = 0;
  std::string end_kind;
  std::string end_reason;
  int64_t faults = 0;  // rewards not paid, and actions not learned from: not finite or too large
  int64_t violations = 0;
  std::vector<double> terms;      // one for each term of the task
  std::vector<double> metrics;    // one for each metric of the task
  std::vector<double> logs;       // one for each log of the task; NaN where nothing was logged
  std::vector<GoalDraw> goals;    // what the robot was told, in the order of time
  std::vector<PhaseSums> phases;  // one for each phase of the task
};

// What the learner shows of itself: a name of its own, and the value of one episode.
struct NamedValue {
  std::string name;
  double value = 0;
  bool operator==(const NamedValue&) const = default;
};

struct EpisodeRecord {
  int64_t number = 0;  // from 1
  int64_t steps = 0;
  int64_t actions = 0;
  double simulated_seconds = 0;
  double wall_seconds = 0;  // that the run has waited for it
  double cpu_seconds = 0;   // of the thread that ran it, and learned from it
  Evaluation active;        // of the task that paid the learner at the episode's end
  std::vector<Evaluation> shadows;
  std::vector<NamedValue> learner;
};

// What the task with this id says of the episode; null where it did not run in it.
Evaluation* FindEvaluation(EpisodeRecord& episode, int64_t task);

// What a client did to the run that has an effect on learning or on the record. The changes are the
// journal that is repeated when a run goes on from a checkpoint.
struct ChangeRecord {
  int64_t id = 0;       // from 1
  int64_t episode = 0;  // in which it took effect; the next one, for a change between two episodes
  int64_t step = 0;     // time steps done in that episode before it
  std::string at;       // ISO 8601; "" for one that is about to be added: the time at which it is
  Change change;        // with all that is needed to repeat it
  std::string text;     // for a person: "swap task: crawling (a1b2c3d4)"
};

struct Recording {
  static constexpr int64_t kMostFrames = 1 << 20;  // far more than a recorder ever keeps

  int64_t frames = 0;
  double frame_interval = 0;  // [s]
  bool is_best = false;
  std::string poses;       // compressed, see schema.sql
  std::string timeline{};  // the same, of timeline.h; "" where there is none
};

// An episode of which there is a recording.
struct RecordedEpisode {
  int64_t number = 0;
  int64_t frames = 0;
};

struct Checkpoint {
  int64_t episode = 0;  // the last that is part of it
  std::string state;    // compressed, see checkpoint.h
};

}  // namespace runtime
