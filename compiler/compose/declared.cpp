#include "compiler/compose/declared.h"

#include <variant>

namespace compiler {
namespace {

std::string_view KindOf(const StartDeclaration&) { return "start"; }
std::string_view KindOf(const AfterEndDeclaration&) { return "after_end"; }
std::string_view KindOf(const SensorDeclaration&) { return "sensor"; }
std::string_view KindOf(const ParamDeclaration&) { return "param"; }
std::string_view KindOf(const ParamOverride&) { return "param"; }
std::string_view KindOf(const ConstDeclaration&) { return "const"; }
std::string_view KindOf(const ConstOverride&) { return "const"; }
std::string_view KindOf(const SetDeclaration&) { return "set"; }
std::string_view KindOf(const TableDeclaration&) { return "table"; }
std::string_view KindOf(const TableOverride&) { return "table"; }
std::string_view KindOf(const MemoryDeclaration&) { return "memory"; }
std::string_view KindOf(const GoalDeclaration&) { return "goal"; }
std::string_view KindOf(const GoalOverride&) { return "goal"; }
std::string_view KindOf(const ObserveDeclaration&) { return "observe"; }
std::string_view KindOf(const OnboardDeclaration&) { return "onboard"; }
std::string_view KindOf(const MetricDeclaration&) { return "metric"; }
std::string_view KindOf(const RewardOverride&) { return "reward"; }
std::string_view KindOf(const PotentialDeclaration&) { return "reward"; }
std::string_view KindOf(const EventDeclaration&) { return "on"; }
std::string_view KindOf(const PhaseDeclaration&) { return "phase"; }
std::string_view KindOf(const FunctionDeclaration&) { return "fn"; }
std::string_view KindOf(const ImportDeclaration&) { return "import"; }
std::string_view KindOf(const TestDeclaration&) { return "test"; }

const Identifier& NameIn(const StartDeclaration& start) { return start.poses.front(); }
const Identifier& NameIn(const AfterEndDeclaration& after) { return after.word; }
const Identifier& NameIn(const OnboardDeclaration& onboard) { return onboard.word; }
const Identifier& NameIn(const RewardOverride& changed) { return changed.reward.name; }
const Identifier& NameIn(const ImportDeclaration&) {
  static const Identifier none;
  return none;
}
const Identifier& NameIn(const TestDeclaration&) {
  static const Identifier none;
  return none;
}
template <typename Node>
const Identifier& NameIn(const Node& node) {
  return node.name;
}

}  // namespace

std::string_view KindOf(const Declaration& declaration) {
  return std::visit([](const auto& node) { return KindOf(node); }, declaration.node);
}

const Identifier& NameOf(const Declaration& declaration) {
  return std::visit([](const auto& node) -> const Identifier& { return NameIn(node); },
                    declaration.node);
}

bool IsKnown(const Declaration& declaration) {
  const auto* event = std::get_if<EventDeclaration>(&declaration.node);
  return event == nullptr || event->is_known;
}

bool IsOnly(std::string_view kind) { return kind == "start" || kind == "after_end"; }

bool AreOfTheSame(const Declaration& a, const Declaration& b) {
  if (KindOf(a) != KindOf(b) || !IsKnown(a) || !IsKnown(b)) return false;
  return IsOnly(KindOf(a)) || NameOf(a).text == NameOf(b).text;
}

}  // namespace compiler
