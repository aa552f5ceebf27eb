#include "runtime/trainer/setup/agent_presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "base/command_line/command.h"
#include "runtime/base/suggestion.h"
#include "runtime/core/agent/agent.h"

namespace runtime {
namespace {

using command_line::CallError;

std::string FirstComment(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  if (!line.starts_with('#')) return "";
  return line.substr(std::min(line.find_first_not_of("# "), line.size()));
}

// Those of names that are not there yet.
void AddPresetsIn(const std::filesystem::path& folder, std::vector<AgentPreset>& presets) {
  std::error_code error;  // a folder that is not there has none
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string file = entry.path().filename().string();
    if (!file.ends_with(kAgentEnding) || file.size() == kAgentEnding.size()) continue;
    const std::string name = file.substr(0, file.size() - kAgentEnding.size());
    if (std::ranges::find(presets, name, &AgentPreset::name) != presets.end()) continue;
    presets.push_back({name, FirstComment(entry.path()), entry.path()});
  }
}

}  // namespace

std::vector<AgentPreset> AgentPresetsOf(const std::filesystem::path& robot_folder) {
  std::vector<AgentPreset> presets;
  AddPresetsIn(robot_folder, presets);
  AddPresetsIn(AgentsOfAnyRobot(), presets);
  std::ranges::sort(presets, {}, &AgentPreset::name);
  return presets;
}

std::filesystem::path FindAgentFile(const std::string& agent,
                                    const std::filesystem::path& robot_folder) {
  if (agent.empty()) return {};
  if (IsAgentFile(agent)) {
    if (std::filesystem::is_regular_file(agent)) return agent;
    throw CallError(fmt::format("--agent {}: there is no such file", agent));
  }
  std::vector<std::string> names;
  for (const AgentPreset& preset : AgentPresetsOf(robot_folder)) {
    if (preset.name == agent) return preset.file;
    names.push_back(preset.name);
  }
  throw CallError(fmt::format(
      "--agent {}: the robot has no such agent{} (a file has `/` or `.toml` in its name)", agent,
      Suggestion(agent, names)));
}

}  // namespace runtime
