#include "compiler/check/observations.h"

#include <map>
#include <string>
#include <utility>

#include "compiler/check/expressions.h"
#include "compiler/check/names.h"
#include "compiler/check/phase_names.h"
#include "compiler/check/report.h"

namespace compiler {
namespace {

class ObservationCheck {
 public:
  ObservationCheck(TaskScope& scope, CheckedTask& task) : scope_(scope), task_(task) {}

  void Check(const ObserveDeclaration& observation) {
    CheckName(observation);
    auto value = PhaseFlags(observation.value, scope_);
    if (!value) value = CheckExpression(observation.value, {Place::kObservation}, scope_);
    if (!value) {
      scope_.refused.insert(observation.name.text);
      return;
    }
    const uint32_t offset = task_.observation_size;
    task_.observation_size += value->type.size();
    if (offset <= kMostObserved && task_.observation_size > kMostObserved)
      Report(scope_.diagnostics, code::kTooMuchObserved, observation.value.span,
             fmt::format("with this the learner would see more than {} numbers", kMostObserved),
             {.help = "observe only what the rewards depend on"});
    task_.observations.push_back({.name = observation.name.text,
                                  .doc = observation.doc,
                                  .value = std::move(*value),
                                  .offset = offset,
                                  .has_name = observation.has_name,
                                  .span = observation.name.span});
  }

  void Check(const OnboardDeclaration& onboard) {
    task_.onboard = onboard.word.span;
    if (!scope_.knows_robot || scope_.has_robot) return;
    Report(scope_.diagnostics, code::kOnboardWithoutRobot, onboard.word.span,
           "what can be sensed onboard is known only of a robot",
           {.help = "write `for ROBOT` after the task's name, or leave out `observe onboard`"});
  }

 private:
  void CheckName(const ObserveDeclaration& observation) {
    const Identifier& name = observation.name;
    if (observation.has_name) NoteReference(name, ReferenceKind::kObservation, scope_);
    const auto [first, is_new] = seen_.try_emplace(name.text, name.span);
    if (is_new) return;
    Report(scope_.diagnostics, code::kRepeatedName, name.span,
           fmt::format("there is already an observation `{}`", name.text),
           {.help = observation.has_name ? "" : "leave it out, or give it a name of its own",
            .labels = {{first->second, "first declared here"}}});
  }

  TaskScope& scope_;
  CheckedTask& task_;
  std::map<std::string, Span> seen_;
};

}  // namespace

void CheckObservations(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task) {
  ObservationCheck check(scope, task);
  for (const Declaration& declaration : tree.declarations) {
    if (const auto* observation = std::get_if<ObserveDeclaration>(&declaration.node))
      check.Check(*observation);
    if (const auto* onboard = std::get_if<OnboardDeclaration>(&declaration.node))
      check.Check(*onboard);
  }
}

}  // namespace compiler
