// Parameters that move from one value to another over episodes.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "runtime/live/control/live_graph.h"

namespace runtime {

struct Schedule {
  double from = 0;
  double to = 0;
  int64_t first_episode = 0;  // has the value `from`
  int64_t episodes = 1;       // the last of them has the value `to`

  // Linear between the two, and constant outside.
  double At(int64_t episode) const;
  bool IsOverAfter(int64_t episode) const { return episode >= first_episode + episodes - 1; }
};

class Schedules {
 public:
  // In the place of one that `parameter` ("task.weight") may have.
  void Set(const std::string& parameter, const Schedule& schedule);
  void Remove(const std::string& parameter) { schedules_.erase(parameter); }

  // Gives all parameters their values for an episode that is about to start. A schedule whose
  // parameter is gone, or does not take its value any more, is dropped.
  void Apply(int64_t episode, LiveGraph& graph);

  // Gives the parameters of a copy of the graph the values that they will have in an episode that
  // comes later.
  void Anticipate(int64_t episode, ModuleGraph& copy) const;

  const std::map<std::string, Schedule>& all() const { return schedules_; }

 private:
  std::map<std::string, Schedule> schedules_;
};

}  // namespace runtime
