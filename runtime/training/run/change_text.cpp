#include "runtime/training/run/change_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "runtime/training/run/value_json.h"

namespace runtime {
namespace {

const char* Forgetting(bool forget) { return forget ? ", what was learned is forgotten" : ""; }

// What holds for every kind that needs no more: "unload careful".
template <class Kind>
std::string Plain(const Kind& change, std::string_view of) {
  return fmt::format("{} {}", change.kKind, of);
}

class Describer {
 public:
  explicit Describer(const RunRecord& run) : run_(run) {}

  std::string operator()(const SwapTask& change) const {
    return Task(change) + Forgetting(change.forget);
  }
  std::string operator()(const LoadShadow& change) const { return Task(change); }
  std::string operator()(const RollBackTask& change) const { return Task(change); }
  std::string operator()(const PromoteTask& change) const {
    return Plain(change, change.module) + Forgetting(change.forget);
  }
  std::string operator()(const UnloadShadow& change) const { return Plain(change, change.module); }
  std::string operator()(const SetParameter& change) const {
    return fmt::format("{} = {}", change.parameter, ToJson(change.value).dump());
  }
  std::string operator()(const ScheduleParameter& change) const {
    return fmt::format("{}: {} to {} over {} episodes", change.parameter,
                       ToJson(change.from).dump(), ToJson(change.to).dump(), change.episodes);
  }
  std::string operator()(const HoldGoal& change) const {
    return Plain(change, fmt::format("{} at {}", change.goal, ToJson(change.value).dump()));
  }
  std::string operator()(const ReleaseGoal& change) const { return Plain(change, change.goal); }
  std::string operator()(const ConnectPorts& change) const {
    return Plain(change, change.first + " " + change.second);
  }
  std::string operator()(const DisconnectPorts& change) const {
    return Plain(change, change.first + " " + change.second);
  }
  std::string operator()(const AddModule& change) const {
    return fmt::format("add module {} {}", change.type, change.module);
  }
  std::string operator()(const RemoveModule& change) const {
    return fmt::format("remove module {}", change.module);
  }
  std::string operator()(const PutInQuarantine& change) const { return Plain(change, change.why); }
  std::string operator()(const UnknownChange& change) const { return change.kind; }

 private:
  template <class Kind>
  std::string Task(const Kind& change) const {
    return fmt::format("{} {}: {}", change.kKind, change.module,
                       VersionText(TaskWithId(run_, change.task)));
  }

  const RunRecord& run_;
};

}  // namespace

std::string TextOf(const Change& change, const RunRecord& run) {
  return std::visit(Describer(run), change);
}

}  // namespace runtime
