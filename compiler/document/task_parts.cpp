#include "compiler/document/task_parts.h"

#include <algorithm>

namespace compiler {
namespace {

// "the end of a time step" for `end_of_time_step`.
std::string InWords(std::string event) {
  std::ranges::replace(event, '_', ' ');
  const size_t of = event.find(" of ") + 4;
  const bool has_vowel = event[of] == 'e' || event[of] == 'a';
  return "the " + event.insert(of, has_vowel ? "an " : "a ");
}

}  // namespace

TaskParts::TaskParts(const Analysis& of)
    : analysis(of), task(*of.task), tree(*of.tree), weights(FindWeights(task)) {
  for (const EventDeclaration* event : All<EventDeclaration>(tree))
    statements.push_back(
        {EquationsOf(*event), event->name.text, "at " + InWords(event->name.text)});
  for (const PhaseDeclaration* phase : All<PhaseDeclaration>(tree))
    statements.push_back(
        {EquationsOf(*phase), "phase " + phase->name.text, "in the phase " + phase->name.text});
}

Text WhenText(const std::string& condition) {
  return condition.empty() ? Plain("always") : Math(condition);
}

}  // namespace compiler
