#include "runtime/trainer/setup/agent_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/command_line/command.h"
#include "runtime/base/user_error.h"
#include "runtime/trainer/setup/agent_presets.h"
#include "runtime/training/environment/socket_environment.h"
#include "runtime/training/simulation/robot_environment.h"

namespace runtime {
namespace {

using command_line::CallError;

constexpr const char* kSetOption = "--set";

// Texts that start like a word need no quotes on the command line.
std::string TomlValue(const std::string& value) {
  const bool is_word = !value.empty() && std::isalpha(static_cast<unsigned char>(value[0])) != 0;
  const bool is_plain = value == "true" || value == "false" || value == "inf" || value == "nan";
  return value.empty() || (is_word && !is_plain) ? fmt::format("'{}'", value) : value;
}

// The name of a task's own sensor may have dots.
std::string TomlKey(const std::string& parameter) {
  return parameter.find('.') == std::string::npos ? parameter : fmt::format("'{}'", parameter);
}

// What can be called so may begin with a digit, as the net `3_g5` does.
bool IsName(const std::string& value) {
  return !value.empty() && std::ranges::all_of(value, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_';
  });
}

// `name` = `value`, as TOML writes it. Throws UserError where that is no TOML.
Agent SettingOf(const std::string& name, const std::string& value, const SourcePlace& place) {
  Agent change = ParseAgent(fmt::format("{} = {}", name, value), kSetOption);
  for (ModuleSetting& module : change.modules) {
    module.place = place;
    for (ParameterSetting& parameter : module.parameters) parameter.place = place;
  }
  return change;
}

// The environment, which is of this type. `origin`: who needs it.
const ModuleSetting& EnvironmentOf(const Agent& agent, const std::string& type,
                                   const std::string& origin) {
  const auto environment = std::ranges::find(agent.modules, type, &ModuleSetting::type);
  if (environment != agent.modules.end()) return *environment;
  throw UserError(
      fmt::format("{}: the agent has no module of the type `{}` to set it in", origin, type));
}

// `agent` with a parameter of its environment. `origin`: where it comes from, as messages name it.
Agent WithEnvironment(const Agent& agent, const std::string& type, const std::string& parameter,
                      const std::string& value, const std::string& origin) {
  const SourcePlace place{origin};
  Agent change;
  change.modules = {
      {EnvironmentOf(agent, type, origin).name, "", place, {{parameter, value, place}}}};
  return Changed(agent, change);
}

const ParameterSetting* FindParameter(const Agent& agent, const std::string& module,
                                      const std::string& name) {
  const auto owner = std::ranges::find(agent.modules, module, &ModuleSetting::name);
  if (owner == agent.modules.end()) return nullptr;
  const auto found = std::ranges::find(owner->parameters, name, &ParameterSetting::name);
  return found == owner->parameters.end() ? nullptr : &*found;
}

// "--set", or the place in a file.
std::string OriginOf(const SourcePlace& place) {
  return place.line == 0 ? kSetOption : place.ToText();
}

}  // namespace

Agent ParseSetting(const std::string& setting) {
  const size_t equals = setting.find('=');
  const size_t dot = setting.find('.');
  if (equals == std::string::npos || dot == std::string::npos || dot == 0 || dot + 1 >= equals) {
    throw CallError(fmt::format(
        "--set {}: write MODULE.PARAMETER=VALUE, for example `--set learner.temperature=2`",
        setting));
  }
  const std::string name = fmt::format("modules.{}.{}", setting.substr(0, dot),
                                       TomlKey(setting.substr(dot + 1, equals - dot - 1)));
  const std::string value = setting.substr(equals + 1);
  const SourcePlace place{fmt::format("{} {}", kSetOption, setting)};
  try {
    return SettingOf(name, TomlValue(value), place);
  } catch (const UserError&) {
    if (IsName(value)) return SettingOf(name, fmt::format("'{}'", value), place);
    throw CallError(fmt::format(
        "--set {}: this is not a value: write a number, true, false, \"text\" or [1, 2]", setting));
  }
}

Agent AgentLayers::Read(const std::filesystem::path& file) const {
  return ReadAgent(file, robot_folder);
}

bool AgentLayers::IsOfRobot(const SourcePlace& place) const {
  const std::filesystem::path folder = std::filesystem::path(place.file).parent_path();
  return folder == robot_folder || folder == AgentsOfAnyRobot();
}

void AgentLayers::AddTaskFile(const std::string& extension, Agent& merged) const {
  std::filesystem::path file = task_file;
  file.replace_extension(extension);
  if (std::filesystem::exists(file)) merged = Changed(std::move(merged), Read(file));
}

Agent AgentLayers::Merge() const {
  const std::filesystem::path own = robot_folder / "agent.toml";
  Agent merged =
      Read(std::filesystem::exists(own) ? own : FindAgentFile(kAgentOfAnyRobot, robot_folder));
  AddTaskFile(".agent.toml", merged);
  if (!agent.empty()) {
    merged = Changed(std::move(merged), Read(FindAgentFile(agent, robot_folder)));
    if (!IsAgentFile(agent)) AddTaskFile(fmt::format(".{}.agent.toml", agent), merged);
  }
  if (!profile.empty()) {
    merged = WithEnvironment(merged, RobotEnvironment::kType, "profile", profile,
                             "--profile " + profile);
  }
  if (!environment_socket.empty()) {
    merged = WithEnvironment(merged, SocketEnvironment::kType, "path", environment_socket,
                             "--environment-socket");
  }
  for (const std::string& setting : settings) {
    merged = Changed(std::move(merged), ParseSetting(setting));
  }
  return merged;
}

Agent AgentLayers::Changes() const {
  Agent changes = IsAgentFile(agent) ? Read(FindAgentFile(agent, robot_folder)) : Agent{};
  for (const std::string& setting : settings) {
    changes = Joined(std::move(changes), ParseSetting(setting));
  }
  return changes;
}

std::vector<Setting> AgentLayers::SettingsIn(const Agent& merged, const Agent& changes) const {
  std::vector<Setting> found;
  for (const ModuleSetting& module : changes.modules) {
    for (const ParameterSetting& parameter : module.parameters) {
      const ParameterSetting* value = FindParameter(merged, module.name, parameter.name);
      if (value == nullptr || value->place.ToText() != parameter.place.ToText()) continue;
      if (IsOfRobot(parameter.place)) continue;  // included
      found.push_back(
          {module.name + "." + parameter.name, ToText(value->value), OriginOf(parameter.place)});
    }
  }
  return found;
}

}  // namespace runtime
