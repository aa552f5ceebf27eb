#include "runtime/live/control/schedules.h"

#include <cmath>

namespace runtime {
namespace {

// A whole parameter moves in whole steps.
ParameterValue ValueFor(const Parameter& parameter, double value) {
  if (std::holds_alternative<double*>(parameter.target)) return value;
  return static_cast<int64_t>(std::llround(value));
}

}  // namespace

double Schedule::At(int64_t episode) const {
  if (episode < first_episode) return from;
  if (IsOverAfter(episode)) return to;
  const double done =
      static_cast<double>(episode - first_episode) / static_cast<double>(episodes - 1);
  return from + (to - from) * done;
}

void Schedules::Set(const std::string& parameter, const Schedule& schedule) {
  schedules_[parameter] = schedule;
}

void Schedules::Apply(int64_t episode, LiveGraph& graph) {
  std::erase_if(schedules_, [&](const auto& each) {
    const auto& [parameter, schedule] = each;
    try {
      graph.Set(parameter, ValueFor(graph.FindParameter(parameter), schedule.At(episode)));
    } catch (const UserError&) {
      return true;
    }
    return schedule.IsOverAfter(episode);
  });
}

void Schedules::Anticipate(int64_t episode, ModuleGraph& copy) const {
  for (const auto& [name, schedule] : schedules_) {
    const size_t dot = name.find('.');
    try {
      Module& module = copy.Find(name.substr(0, dot));
      const Parameter& parameter = module.FindParameter(name.substr(dot + 1));
      module.Set(parameter.name, ValueFor(parameter, schedule.At(episode)));
    } catch (const UserError&) {
      // It has none of these values by then.
    }
  }
}

}  // namespace runtime
