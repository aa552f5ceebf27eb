#include "runtime/core/module/sensor_type.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <utility>

#include "plugins/robot/sensors.h"

namespace runtime {

size_t ElementsOfType(std::string_view type, const robot::RobotDescription& robot) {
  constexpr std::pair<std::string_view, size_t> kTypes[] = {
      {"bool", 1}, {"int", 1},  {"real", 1}, {"vec2", 2}, {"vec3", 3},
      {"vec4", 4}, {"quat", 4}, {"mat2", 4}, {"mat3", 9}, {"mat4", 16}};
  const size_t bracket = std::min(type.find('['), type.size());
  const auto* entry = std::ranges::find(kTypes, type.substr(0, bracket),
                                        [](const auto& each) { return each.first; });
  if (entry == std::end(kTypes)) return 0;
  if (bracket == type.size()) return entry->second;
  if (type.size() < bracket + 3 || !type.ends_with(']')) return 0;
  const std::string_view index = type.substr(bracket + 1, type.size() - bracket - 2);
  if (const auto count = robot::EntryCount(index, robot)) return entry->second * *count;
  size_t count = 0;
  std::from_chars(index.data(), index.data() + index.size(), count);
  return entry->second * count;
}

}  // namespace runtime
