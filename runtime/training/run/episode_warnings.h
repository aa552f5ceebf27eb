// What a user should know of an episode that did not go as it should.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/task/universal_task.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

class EpisodeWarnings {
 public:
  // `run` outlives this object.
  EpisodeWarnings(const RunRecord& run, std::function<void(const std::string&)> warn)
      : run_(run), warn_(std::move(warn)) {}

  // Whether a term was not paid in the episode that was paid in all before.
  bool HasNewFault(const UniversalTask& task) const;

  // `task` was active in the episode, which is the last that both have had.
  void About(const EpisodeRecord& episode, const UniversalTask& task, const Learner& learner);

 private:
  void AboutFaults(const EpisodeRecord& episode, const UniversalTask& task);
  void AboutLearner(const EpisodeRecord& episode, const Learner& learner);
  void AboutViolations(const EpisodeRecord& episode, const UniversalTask& task);
  void AboutObservations(const EpisodeRecord& episode, const UniversalTask& task);

  // Of the first fault that a term has in the run; "" for later ones.
  std::string Explanation(const UniversalTask& task);

  const RunRecord& run_;
  std::function<void(const std::string&)> warn_;
  std::set<std::pair<int64_t, size_t>> explained_;  // terms, by their task (TaskRecord::id)
  // Of each task (TaskRecord::id), for each requirement: whether a warning was given.
  std::map<int64_t, std::vector<bool>> violations_noted_;
};

}  // namespace runtime
