// When memory is given its initial value again.
#pragma once

#include "compiler/syntax/syntax_tree.h"

namespace compiler {

inline bool IsResetAt(EventKind event, MemoryScope scope) {
  if (event == EventKind::kStartOfEpisode) return scope != MemoryScope::kPerRun;
  return event == EventKind::kStartOfAction && scope == MemoryScope::kPerAction;
}

}  // namespace compiler
