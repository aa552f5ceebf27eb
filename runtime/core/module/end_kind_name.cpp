#include "runtime/core/module/end_kind_name.h"

#include <algorithm>
#include <cstdlib>

namespace runtime {

std::string_view EndKindName(EndKind kind) {
  switch (kind) {
    case EndKind::kSuccess:
      return "success";
    case EndKind::kFailure:
      return "failure";
    case EndKind::kTruncated:
      return "truncated";
    case EndKind::kDiverged:
      return "diverged";
  }
  std::abort();
}

std::optional<EndKind> EndKindCalled(std::string_view name) {
  const auto* kind = std::ranges::find(kEndKinds, name, EndKindName);
  if (kind == kEndKinds.end()) return std::nullopt;
  return *kind;
}

}  // namespace runtime
