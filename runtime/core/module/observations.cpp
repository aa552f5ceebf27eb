#include "runtime/core/module/observations.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/base/user_error.h"
#include "runtime/core/module/module.h"

namespace runtime {
namespace {

std::string Describe(const ObservationLayout& layout, size_t index) {
  if (layout.values.empty()) return "what the robot senses";
  if (index == layout.values.size()) return "nothing";
  const ObservedValue& value = layout.values[index];
  return fmt::format("`{}` ({}{})", value.name, value.type,
                     value.unit.empty() ? "" : " [" + value.unit + "]");
}

bool IsSame(const ObservedValue& a, const ObservedValue& b) {
  return a.name == b.name && a.type == b.type && a.unit == b.unit && a.size == b.size;
}

}  // namespace

std::optional<ObservationLayout> LayoutShownBy(const Module& module) {
  for (const Port* port : module.ports()) {
    const auto* layout = dynamic_cast<const Out<ObservationLayout>*>(port);
    if (layout == nullptr) continue;
    try {
      return (*layout)();
    } catch (const UserError&) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

void CheckSameLayout(const ObservationLayout& expected, const ObservationLayout& layout,
                     const std::string& what) {
  const auto [first, other] = std::ranges::mismatch(expected.values, layout.values, &IsSame);
  if (first == expected.values.end() && other == layout.values.end()) return;
  const auto index = static_cast<size_t>(first - expected.values.begin());
  throw UserError(fmt::format(
      "the learner cannot go on with {}: it would see {} instead of {}; train it in a run of its "
      "own",
      what, Describe(layout, index), Describe(expected, index)));
}

}  // namespace runtime
