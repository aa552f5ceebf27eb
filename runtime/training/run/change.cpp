#include "runtime/training/run/change.h"

#include "base/variant/overloaded.h"

namespace runtime {

double AsReal(const WrittenNumber& number) {
  return std::visit([](auto each) { return static_cast<double>(each); }, number);
}

std::string_view KindOf(const Change& change) {
  return std::visit(
      variant::Overloaded{
          [](const UnknownChange& unknown) -> std::string_view { return unknown.kind; },
          []<class Known>(const Known&) { return Known::kKind; },
      },
      change);
}

std::optional<TaskOfModule> TaskBroughtBy(const Change& change) {
  using Result = std::optional<TaskOfModule>;
  return std::visit(
      variant::Overloaded{
          [](const variant::OneOf<SwapTask, LoadShadow, RollBackTask> auto& each) -> Result {
            return TaskOfModule{each.module, each.task};
          },
          [](const variant::OneOf<PromoteTask, UnloadShadow, SetParameter, ScheduleParameter,
                                  HoldGoal, ReleaseGoal, ConnectPorts, DisconnectPorts, AddModule,
                                  RemoveModule, PutInQuarantine, UnknownChange> auto&) -> Result {
            return std::nullopt;
          },
      },
      change);
}

bool ChangesReward(const Change& change, std::string_view module) {
  return std::visit(
      variant::Overloaded{
          [](const variant::OneOf<SwapTask, RollBackTask, PromoteTask> auto&) { return true; },
          [&](const variant::OneOf<SetParameter, ScheduleParameter> auto& each) {
            return each.parameter.starts_with(std::string(module) + ".");
          },
          [&](const variant::OneOf<HoldGoal, ReleaseGoal> auto& each) {
            return each.goal.starts_with(std::string(module) + ".");
          },
          [](const variant::OneOf<LoadShadow, UnloadShadow, ConnectPorts, DisconnectPorts,
                                  AddModule, RemoveModule, PutInQuarantine, UnknownChange> auto&) {
            return false;
          },
      },
      change);
}

}  // namespace runtime
