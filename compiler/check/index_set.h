// What stands in the brackets of `contact[links - {body, head} - feet]`: a set of indices.
#pragma once

#include <optional>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// What the set is for.
enum class IndexUse { kIndex, kLoop, kSet };

// What is indexed, gone through by a loop, or gathered in a named set.
struct IndexDomain {
  uint32_t size = 0;
  const Enumeration* names = nullptr;  // null: numbers only
  IndexUse use = IndexUse::kIndex;
};

// The indices of one item of an index list. Every element counts once, in the order in which it is
// first named; the set is never empty and all members are below domain.size. Nothing if the item is
// wrong, which has then been reported.
std::optional<std::vector<uint32_t>> ResolveIndexItem(const Expression& item,
                                                      const IndexDomain& domain,
                                                      const TaskScope& scope);

// The union of several items.
std::optional<std::vector<uint32_t>> ResolveIndexSet(const std::vector<ExpressionPtr>& items,
                                                     Span span, const IndexDomain& domain,
                                                     const TaskScope& scope);

}  // namespace compiler
