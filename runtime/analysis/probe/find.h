// The motions that a probe of a task has found.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runtime/analysis/behavior/motion.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// How far a recorded motion goes, by the positions of the base.
struct MotionExtremes {
  double speed = 0;   // greatest [m/s]
  double height = 0;  // greatest [m]
};

MotionExtremes ExtremesOf(const Motion& motion);

// An episode that was better than all of its search before it.
struct Find {
  std::string run;  // of the search, as seen from the probe's folder
  uint64_t seed = 0;
  std::string agent;  // of the search, TOML
  EpisodeRecord episode;
  Recording recording;
  MotionExtremes extremes;
  // What the motion has that the robot's description says a sound simulation has not (its table
  // [ranges]): "a speed of 13.1 m/s". Empty: nothing.
  std::vector<std::string> beyond;
  int searches = 1;  // that found a motion like this one

  bool is_sound() const { return beyond.empty(); }
  // Of the motion [Hz], where its search shows one.
  std::optional<double> frequency() const;
};

struct ProbeResults {
  // Different motions at most, each being the best of those like it.
  static constexpr size_t kMostFinds = 6;

  std::string folder;  // as the user called it
  RunRecord record;    // of the first search; the others have other seeds, and other motions
  int searches = 0;
  int64_t episodes = 0;  // of all
  int64_t diverged = 0;  // as many of them
  double cpu_seconds = 0;
  // The sound ones first, the better ones first.
  std::vector<Find> finds;
  size_t left_out = 0;  // finds that would follow
  std::vector<std::string> notes;

  const TaskRecord& task() const { return record.tasks.front(); }
};

// `runs`: the folders of the searches in `folder`, at least one. Throws UserError where no search
// has an episode yet.
ProbeResults ReadProbe(const std::filesystem::path& folder,
                       const std::vector<std::filesystem::path>& runs);

}  // namespace runtime
