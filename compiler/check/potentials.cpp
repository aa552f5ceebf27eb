#include "compiler/check/potentials.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "compiler/check/copy_checked.h"
#include "compiler/check/expressions.h"
#include "compiler/check/hidden_memory.h"
#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

using Moment = CheckedPotentialStep::Moment;

constexpr std::pair<EventKind, Moment> kMoments[] = {
    {EventKind::kStartOfEpisode, Moment::kStart},
    {EventKind::kEndOfAction, Moment::kAction},
    {EventKind::kEndOfEpisode, Moment::kEnd},
};

class PotentialChecker {
 public:
  PotentialChecker(TaskScope& scope, CheckedTask& task) : scope_(scope), task_(task) {
    scope_.locals.clear();
  }

  void Check(const PotentialDeclaration& potential) {
    NoteReference(potential.name, ReferenceKind::kTerm, scope_);
    auto value = CheckRealNumber(potential.value, "a potential", {Place::kPotential}, scope_);
    if (IsPaidOtherwise(potential)) return;
    if (!value) {
      scope_.refused.insert(potential.name.text);
      return;
    }
    Add(potential, *value);
  }

 private:
  // Is there such a term already? That is reported.
  bool IsPaidOtherwise(const PotentialDeclaration& potential) {
    const Identifier& name = potential.name;
    const auto term = std::ranges::find(task_.terms, name.text, &CheckedTerm::name);
    if (term == task_.terms.end()) return false;
    const auto index = static_cast<uint32_t>(term - task_.terms.begin());
    const bool is_potential = std::ranges::find(task_.potentials, index, &CheckedPotential::term) !=
                              task_.potentials.end();
    if (is_potential) {
      Report(scope_.diagnostics, code::kRepeatedName, name.span,
             fmt::format("there is already a potential `{}`", name.text),
             {.help = "add the two up in one of them",
              .labels = {{term->span, "first declared here"}}});
    } else {
      Report(scope_.diagnostics, code::kMixedPotential, name.span,
             fmt::format("`{}` is paid in an event as well", name.text),
             {.note = "what a potential pays for a way and back adds up to nothing, which this "
                      "would break",
              .help = "give one of the two another name",
              .labels = {{term->span, "paid here"}}});
    }
    return true;
  }

  void Add(const PotentialDeclaration& potential, const CheckedExpression& value) {
    const std::string& name = potential.name.text;
    const Span span = potential.name.span;
    const auto index = static_cast<uint32_t>(task_.potentials.size());
    CheckedPotential added{.term = static_cast<uint32_t>(task_.terms.size()), .span = span};
    task_.terms.push_back({name, potential.doc, span});
    const Type flag = ScalarType(Scalar::kBool);
    added.last = AddHiddenMemory(name + "#potential", kRealType, value.unit,
                                 MemoryScope::kPerEpisode, span, task_);
    added.known = AddHiddenMemory(name + "#known", flag, {}, MemoryScope::kPerEpisode, span, task_);
    added.paid = AddHiddenMemory(name + "#paid", flag, {}, MemoryScope::kPerAction, span, task_);
    task_.potentials.push_back(added);
    for (const auto& [event, moment] : kMoments)
      task_.events[static_cast<size_t>(event)].body.push_back(
          {value.span, CheckedPotentialStep{index, moment, CopyOf(value)}});
  }

  TaskScope& scope_;
  CheckedTask& task_;
};

}  // namespace

void CheckPotentials(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task) {
  PotentialChecker checker(scope, task);
  for (const Declaration& declaration : tree.declarations)
    if (const auto* potential = std::get_if<PotentialDeclaration>(&declaration.node))
      checker.Check(*potential);
}

}  // namespace compiler
