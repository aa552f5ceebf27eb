#include "compiler/check/references.h"

#include <iterator>

namespace compiler {

void References::AddUnique(Reference reference) {
  reference.definition =
      unique_.try_emplace({reference.kind, reference.name}, reference.use).first->second;
  Add(reference);
}

const Reference* References::Find(uint32_t offset) const {
  const auto after = by_place_.upper_bound(offset);
  if (after == by_place_.begin()) return nullptr;
  const Reference& reference = std::prev(after)->second;
  return offset <= reference.use.end ? &reference : nullptr;
}

}  // namespace compiler
