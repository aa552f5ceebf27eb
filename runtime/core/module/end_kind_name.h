// The ends of episodes in words, as records and messages have them.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "runtime/core/module/values.h"

namespace runtime {

inline constexpr std::array kEndKinds = {EndKind::kSuccess, EndKind::kFailure, EndKind::kTruncated,
                                         EndKind::kDiverged};

std::string_view EndKindName(EndKind kind);  // "success"
std::optional<EndKind> EndKindCalled(std::string_view name);

}  // namespace runtime
