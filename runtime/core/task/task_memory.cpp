#include "runtime/core/task/task_memory.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "runtime/core/module/sensor_data.h"
#include "runtime/core/task/saved_values.h"

namespace runtime {
namespace {

std::string TypeAndUnit(const taskc_memory& variable) {
  return SensorTypeText(variable.type, variable.unit);
}

}  // namespace

TaskMemory::TaskMemory(host::TaskFrame& host)
    : host_(host), variables_(host.plugin().memory, host.plugin().memory_count) {
  for (const taskc_memory& variable : variables_) {
    if (variable.scope == TASKC_PER_RUN) kept_.push_back(variable);
  }
}

const taskc_memory* TaskMemory::FindSame(std::span<const taskc_memory> variables,
                                         std::string_view name, const std::string& type,
                                         size_t size) {
  const auto found = std::ranges::find_if(variables, [&](const taskc_memory& candidate) {
    return candidate.name == name && TypeAndUnit(candidate) == type &&
           host::SizeInBytes(candidate) == size;
  });
  return found == variables.end() ? nullptr : &*found;
}

void TaskMemory::TakeOver(const TaskMemory& old, bool all) {
  for (const taskc_memory& variable :
       all ? old.variables_ : std::span<const taskc_memory>(old.kept_)) {
    const std::span<const std::byte> bytes = old.host_.Bytes(variable);
    const taskc_memory* same = FindSame(all ? variables_ : std::span<const taskc_memory>(kept_),
                                        variable.name, TypeAndUnit(variable), bytes.size());
    if (same != nullptr) std::memcpy(host_.Bytes(*same).data(), bytes.data(), bytes.size());
  }
}

bool TaskMemory::outlives_episodes() const {
  const taskc_plugin& table = host_.plugin();
  const std::span goals(table.goals, table.goal_count);
  const std::span starts(table.start_values, table.start_value_count);
  return std::ranges::any_of(kept_, [&](const taskc_memory& variable) {
    const auto is_of_goal = [&](const taskc_goal& goal) {
      return variable.offset == goal.offset || variable.offset == goal.held_offset;
    };
    const auto is_of_start = [&](const taskc_start_value& value) {
      return variable.offset == value.offset;
    };
    return std::ranges::none_of(goals, is_of_goal) && std::ranges::none_of(starts, is_of_start);
  });
}

void TaskMemory::Save(std::ostream& stream) const {
  SaveNumber(stream, static_cast<uint32_t>(kept_.size()));
  for (const taskc_memory& variable : kept_) {
    const std::span<const std::byte> bytes = std::as_const(host_).Bytes(variable);
    SaveText(stream, variable.name);
    SaveText(stream, TypeAndUnit(variable));
    SaveText(stream, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
}

void TaskMemory::Load(std::istream& stream) {
  const auto count = LoadNumber<uint32_t>(stream);
  for (uint32_t i = 0; i < count; ++i) {
    const std::string name = LoadText(stream);
    const std::string type = LoadText(stream);
    const std::string content = LoadText(stream);
    const taskc_memory* variable = FindSame(kept_, name, type, content.size());
    if (variable == nullptr) continue;
    std::memcpy(host_.Bytes(*variable).data(), content.data(), content.size());
  }
}

}  // namespace runtime
