// What a user should know of an episode that did not go as it should.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "runtime/core/task/universal_task.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

class EpisodeWarnings {
 public:
  explicit EpisodeWarnings(std::function<void(const std::string&)> warn) : warn_(std::move(warn)) {}

  // `task` was active in the episode, which is the last that both have had.
  void About(const EpisodeRecord& episode, const UniversalTask& task, const Learner& learner);

 private:
  void AboutFaults(const EpisodeRecord& episode, const UniversalTask& task);
  void AboutLearner(const EpisodeRecord& episode, const Learner& learner);
  void AboutViolations(const EpisodeRecord& episode, const UniversalTask& task);
  void AboutObservations(const EpisodeRecord& episode, const UniversalTask& task);

  std::function<void(const std::string&)> warn_;
  // Of each task (TaskRecord::id), for each requirement: whether a warning was given.
  std::map<int64_t, std::vector<bool>> violations_noted_;
};

}  // namespace runtime
