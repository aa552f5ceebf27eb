// From the end that a task reaches until its next episode, its callbacks do nothing: so a payment
// beside an end is made once, whatever the learner does with the rest of its action. A requirement
// that does not hold is such an end, too. A task that says `after_end continue` has none of this.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Adds the variable that says that an end has been reached, where the task needs one: see
// CheckedTask::ended. Precondition: the events have been checked.
void AddMemoryOfEnd(const SyntaxTree& tree, CheckedTask& task);

// Whether the block can end the episode.
bool CanEnd(const CheckedBlock& block);

// Whether callbacks of this event do nothing once an end has been reached.
inline bool StopsAfterEnd(const CheckedTask& task, EventKind event) {
  return task.ended && event != EventKind::kStartOfEpisode && event != EventKind::kEndOfEpisode;
}

}  // namespace compiler
