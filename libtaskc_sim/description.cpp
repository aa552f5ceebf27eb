#include "libtaskc_sim/description.h"

#include <algorithm>
#include <variant>

#include "runtime/core/module/module_graph.h"
#include "runtime/trainer/environment/outside_learner.h"

namespace libtaskc_sim {
namespace {

using runtime::Module;

// How many time steps a decision lasts, where the action space has a parameter that says so; or 0.
int64_t TimeStepsOf(const runtime::DecisionProcess& process) {
  const auto& learner = process.graph().FindOnly<runtime::OutsideLearner>();
  const Module& action_space = learner.FindPort("action_size").Connections().front()->owner();
  const bool is_held =
      std::ranges::any_of(action_space.parameters(), [](const runtime::Parameter& parameter) {
        return parameter.name == "hold" && std::holds_alternative<int*>(parameter.target);
      });
  return is_held ? std::get<int64_t>(action_space.Get("hold")) : 0;
}

}  // namespace

Description::Description(const runtime::TaskSetup& setup, const runtime::DecisionProcess& process,
                         size_t threads, size_t count)
    : layout_(process.observation_layout()), profile_(process.environment().profile()) {
  for (const runtime::ObservedValue& value : layout_.values) {
    observations_.push_back({value.name.c_str(), value.type.c_str(), value.unit.c_str(),
                             static_cast<taskc_uint32>(value.size), value.minimum, value.maximum});
  }
  shown_.task = &setup.plugin->table();
  shown_.robot = setup.robot.name.c_str();
  shown_.profile = profile_.c_str();
  shown_.time_step = process.environment().time_step();
  shown_.decision_time = static_cast<double>(TimeStepsOf(process)) * shown_.time_step;
  shown_.count = static_cast<taskc_uint32>(count);
  shown_.threads = static_cast<taskc_uint32>(threads);
  shown_.action_size = static_cast<taskc_uint32>(process.action_size());
  shown_.observation_size = static_cast<taskc_uint32>(layout_.size());
  shown_.observation_count = static_cast<taskc_uint32>(observations_.size());
  shown_.observations = observations_.data();
}

}  // namespace libtaskc_sim
