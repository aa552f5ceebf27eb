#include "plugins/robot/read_parts.h"
#include "plugins/robot/sensors.h"

namespace robot {
namespace {

const SensorDescription& FindUnlimited(const TomlValue& value, const std::string& name) {
  std::vector<std::string> names;
  for (const SensorDescription& sensor : Sensors()) {
    if (!IsUnlimited(sensor.id)) continue;
    if (sensor.name == name) return sensor;
    names.emplace_back(sensor.name);
  }
  value.Fail(fmt::format("`{}` is not a sensor whose range can be given", name),
             SuggestName(name, names));
}

Range ReadRange(const TomlValue& value) {
  const std::vector<double> ends = value.Numbers(2);
  if (ends[0] >= ends[1]) {
    value.Fail(value.what() + ": the low end is not below the high end", "write [low, high]");
  }
  return {ends[0], ends[1]};
}

// `[low, high]` for all elements, or a list with such a pair for each of them.
std::vector<Range> ReadElements(const TomlValue& value, int count) {
  const std::vector<TomlValue> items = value.Items();
  if (items.empty() || !items.front().IsList()) return {ReadRange(value)};
  if (static_cast<int>(items.size()) != count) {
    value.Fail(fmt::format("{} has {} pairs for {} elements", value.what(), items.size(), count),
               "write [low, high] once for all elements, or for each of them");
  }
  std::vector<Range> ranges;
  for (const TomlValue& item : items) ranges.push_back(ReadRange(item));
  return ranges;
}

}  // namespace

std::vector<NominalRange> ReadNominalRanges(const TomlValue& root, const RobotDescription& robot) {
  std::vector<NominalRange> ranges;
  const auto list = root.Find("ranges");
  if (!list) return ranges;
  for (const auto& [name, entry] : list->Entries()) {
    const TomlValue value = entry.Called(fmt::format("the range of `{}`", name));
    const SensorDescription& sensor = FindUnlimited(value, name);
    ranges.push_back({name, ReadElements(value, ElementCount(sensor, robot))});
  }
  return ranges;
}

}  // namespace robot
