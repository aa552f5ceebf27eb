// All that can be seen of an episode between two of its time steps, as numbers in a row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/module/context.h"
#include "runtime/training/run/episode.h"

namespace runtime {

// Time [s], return, actions begun; of each link and thing the pose (Recorder::kFloatsPerLink), of
// each link whether it has contact; of the active task the terms, metrics, goals, phase, memory,
// sensors and logs; of each shadow its return. What there is not is not a number. A sensor is what
// the task has read last.
class ViewLayout {
 public:
  ViewLayout(const EpisodeModules& modules, const Context& context);

  // Whether the modules still have what they had when this was made.
  bool Fits(const EpisodeModules& modules) const;

  size_t size() const { return size_; }
  // As docs/api.md says under "The view": what the numbers after those of poses and contacts are.
  const std::string& json() const { return json_; }

  // `out`: size() numbers. After `steps` time steps of the episode. Precondition: Fits().
  void Write(const EpisodeModules& modules, int64_t steps, std::span<float> out) const;

 private:
  static void AddTask(const UniversalTask& task, const Context& context, nlohmann::json& values);

  size_t size_ = 0;
  int links_ = 0;
  int poses_ = 0;  // the links, and then the things around the robot
  std::string json_;
  std::vector<std::pair<const UniversalTask*, int64_t>> tasks_;  // with TaskInstance::id()
};

}  // namespace runtime
