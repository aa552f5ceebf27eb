#include "runtime/core/module/element_names.h"

#include <fmt/format.h>

#include <string_view>

namespace runtime {
namespace {

// Whether something stands behind the name as behind a single word.
bool IsOneTerm(std::string_view name) {
  int depth = 0;
  for (const char c : name) {
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (c == ' ' && depth == 0) return false;
  }
  return !name.starts_with('-');
}

// Behind the name of a value, or of an entry of an array, of this type: ".x"; "" of a number.
std::vector<std::string> PartNames(std::string_view type) {
  std::vector<std::string> names;
  if (type == "quat") return {".w", ".x", ".y", ".z"};
  if (type.starts_with("vec")) {
    for (const char letter : std::string_view("xyzw").substr(0, type.back() - '0'))
      names.push_back(fmt::format(".{}", letter));
    return names;
  }
  if (type.starts_with("mat")) {
    const int size = type.back() - '0';
    for (int i = 0; i < size * size; ++i)
      names.push_back(fmt::format("[{}, {}]", i / size, i % size));
    return names;
  }
  return {""};
}

template <class Part>
std::vector<std::string> NamesOf(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (const Part& part : parts) names.push_back(part.name);
  return names;
}

// Behind the name of an array that has as many entries.
std::vector<std::string> EntryNames(std::string_view index, size_t count,
                                    const robot::RobotDescription& robot) {
  if (index == "joint") return NamesOf(robot.joints);
  if (index == "link") return NamesOf(robot.links);
  if (index == "site") return NamesOf(robot.sites);
  std::vector<std::string> names;
  for (size_t i = 0; i < count; ++i) names.push_back(fmt::to_string(i));
  return names;
}

}  // namespace

std::vector<std::string> ElementNames(const ObservedValue& value,
                                      const robot::RobotDescription& robot) {
  const std::string_view type = value.type;
  const size_t bracket = type.find('[');
  const std::vector<std::string> parts = PartNames(type.substr(0, bracket));
  const bool is_number = parts.size() == 1 && bracket == std::string_view::npos;
  const std::string name = is_number || IsOneTerm(value.name) ? value.name : "(" + value.name + ")";
  std::vector<std::string> names;
  if (bracket == std::string_view::npos) {
    for (const std::string& part : parts) names.push_back(name + part);
    return names;
  }
  const std::string_view index = type.substr(bracket + 1, type.size() - bracket - 2);
  for (const std::string& entry : EntryNames(index, value.size / parts.size(), robot)) {
    for (const std::string& part : parts)
      names.push_back(fmt::format("{}[{}]{}", name, entry, part));
  }
  return names;
}

}  // namespace runtime
