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

}  // namespace

std::vector<AgentPreset> AgentPresetsOf(const std::filesystem::path& robot_file) {
  std::vector<AgentPreset> presets;
  for (const auto& entry : std::filesystem::directory_iterator(robot_file.parent_path())) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(kAgentEnding) || name.size() == kAgentEnding.size()) continue;
    presets.push_back({name.substr(0, name.size() - kAgentEnding.size()),
                       FirstComment(entry.path()), entry.path()});
  }
  std::ranges::sort(presets, {}, &AgentPreset::name);
  return presets;
}

std::filesystem::path FindAgentFile(const std::string& agent,
                                    const std::filesystem::path& robot_file) {
  if (agent.empty()) return {};
  if (IsAgentFile(agent)) {
    if (std::filesystem::is_regular_file(agent)) return agent;
    throw CallError(fmt::format("--agent {}: there is no such file", agent));
  }
  std::vector<std::string> names;
  for (const AgentPreset& preset : AgentPresetsOf(robot_file)) {
    if (preset.name == agent) return preset.file;
    names.push_back(preset.name);
  }
  throw CallError(fmt::format(
      "--agent {}: the robot has no such agent{} (a file has `/` or `.toml` in its name)", agent,
      Suggestion(agent, names)));
}

}  // namespace runtime
