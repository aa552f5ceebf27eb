// A recorded episode, simulated again under the eyes of two tasks.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "plugins/robot/robot_description.h"
#include "runtime/core/module/module_graph.h"
#include "runtime/core/task/plugin.h"
#include "runtime/core/task/universal_task.h"
#include "runtime/trainer/rescore/tape_player.h"
#include "runtime/training/run/run_records.h"
#include "runtime/training/simulation/robot_environment.h"

namespace runtime {

// What a task says of an episode.
struct Judgment {
  // Added up in one row. A learner adds up each action by itself, which may be another number in
  // its last digits.
  double episode_return = 0;
  std::string end_kind;
  std::string end_reason;
  double end_time = 0;  // [s] since the start
  std::map<std::string, double> terms;
  std::map<std::string, double> metrics;
};

struct RescoredEpisode {
  int64_t number = 0;
  double recorded_return = 0;  // as the run has it
  Judgment old_task;           // by the task of the run, with the defaults of its params
  Judgment new_task;
  // Where the two first differ in what they have paid, or in whether they have ended.
  struct Difference {
    double time = 0;   // [s] since the start
    std::string what;  // a term, or "end"
  };
  std::optional<Difference> first_difference;
};

// The robot of a run with two tasks that only look on.
class Rescorer {
 public:
  // `robot` outlives this. Throws UserError where a task does not fit it, or reads what no robot
  // senses.
  Rescorer(const robot::RobotDescription& robot, const std::string& profile, uint64_t seed,
           std::shared_ptr<const Plugin> old_task, std::shared_ptr<const Plugin> new_task);

  // `packed`: the tape of the recording. Throws UserError where there is none, or where the robot
  // does not move as it did: each frame of the recording is compared, bit by bit.
  RescoredEpisode Rescore(const EpisodeRecord& episode, const Recording& recording,
                          const std::string& packed);

 private:
  UniversalTask& Add(const char* name, const robot::RobotDescription& robot,
                     std::shared_ptr<const Plugin> plugin, uint64_t seed);

  ModuleGraph graph_;
  RobotEnvironment* environment_;
  UniversalTask* old_task_;
  UniversalTask* new_task_;
  TapePlayer* player_;
};

}  // namespace runtime
