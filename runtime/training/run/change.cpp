#include "runtime/training/run/change.h"

#include "runtime/base/overloaded.h"

namespace runtime {

double AsReal(const WrittenNumber& number) {
  return std::visit([](auto each) { return static_cast<double>(each); }, number);
}

std::string_view KindOf(const Change& change) {
  return std::visit(
      Overloaded{
          [](const UnknownChange& unknown) -> std::string_view { return unknown.kind; },
          []<class Known>(const Known&) { return Known::kKind; },
      },
      change);
}

std::optional<TaskOfModule> TaskBroughtBy(const Change& change) {
  using Result = std::optional<TaskOfModule>;
  return std::visit(
      Overloaded{
          [](const OneOf<SwapTask, LoadShadow, RollBackTask> auto& each) -> Result {
            return TaskOfModule{each.module, each.task};
          },
          [](const OneOf<PromoteTask, UnloadShadow, SetParameter, ScheduleParameter, ConnectPorts,
                         DisconnectPorts, AddModule, RemoveModule, PutInQuarantine,
                         UnknownChange> auto&) -> Result { return std::nullopt; },
      },
      change);
}

bool ChangesReward(const Change& change, std::string_view module) {
  return std::visit(
      Overloaded{
          [](const OneOf<SwapTask, RollBackTask, PromoteTask> auto&) { return true; },
          [&](const OneOf<SetParameter, ScheduleParameter> auto& each) {
            return each.parameter.starts_with(std::string(module) + ".");
          },
          [](const OneOf<LoadShadow, UnloadShadow, ConnectPorts, DisconnectPorts, AddModule,
                         RemoveModule, PutInQuarantine, UnknownChange> auto&) { return false; },
      },
      change);
}

}  // namespace runtime
