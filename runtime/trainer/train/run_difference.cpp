#include "runtime/trainer/train/run_difference.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "runtime/core/agent/agent.h"

namespace runtime {
namespace {

constexpr size_t kMostNamed = 5;

// All that an agent says of its modules: "learner.temperature" and its value.
std::map<std::string, std::string> ValuesOf(const std::string& text) {
  std::map<std::string, std::string> values;
  for (const ModuleSetting& module : ParseAgent(text, "agent").modules) {
    values[module.name + ".type"] = module.type;
    for (const ParameterSetting& parameter : module.parameters) {
      values[module.name + "." + parameter.name] = ToText(parameter.value);
    }
  }
  return values;
}

std::string ValueOr(const std::map<std::string, std::string>& values, const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? "nothing" : found->second;
}

void AddAgents(const std::string& there, const std::string& here,
               std::vector<std::string>& differences) {
  const std::map<std::string, std::string> old_values = ValuesOf(there);
  const std::map<std::string, std::string> new_values = ValuesOf(here);
  std::set<std::string> names;
  for (const auto* values : {&old_values, &new_values}) {
    for (const auto& [name, value] : *values) names.insert(name);
  }
  size_t count = 0;
  for (const std::string& name : names) {
    const std::string old_value = ValueOr(old_values, name);
    const std::string new_value = ValueOr(new_values, name);
    if (old_value == new_value || ++count > kMostNamed) continue;
    differences.push_back(fmt::format("`{}` is {} there and {} here", name, old_value, new_value));
  }
  if (count > kMostNamed) differences.push_back(fmt::format("and {} more", count - kMostNamed));
  if (count == 0) differences.emplace_back("the agent's connections or composites");
}

}  // namespace

std::vector<std::string> DifferencesOf(const RunRecord& there, const RunRecord& here) {
  std::vector<std::string> differences;
  if (there.tasks.front().task_hash != here.tasks.front().task_hash) {
    differences.emplace_back("the text of the task");
  }
  if (there.robot_description != here.robot_description) differences.emplace_back("the robot");
  if (there.agent != here.agent) AddAgents(there.agent, here.agent, differences);
  return differences;
}

}  // namespace runtime
