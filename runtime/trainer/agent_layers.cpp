#include "runtime/trainer/agent_layers.h"

#include <fmt/format.h>

#include <cctype>

#include "runtime/trainer/call_error.h"

namespace runtime {
namespace {

// Texts that start like a word need no quotes on the command line.
std::string TomlValue(const std::string& value) {
  const bool is_word = !value.empty() && std::isalpha(static_cast<unsigned char>(value[0])) != 0;
  const bool is_plain = value == "true" || value == "false" || value == "inf" || value == "nan";
  return value.empty() || (is_word && !is_plain) ? fmt::format("'{}'", value) : value;
}

}  // namespace

Agent ParseSetting(const std::string& setting, const std::string& origin) {
  const size_t equals = setting.find('=');
  const size_t dot = setting.find('.');
  if (equals == std::string::npos || dot == std::string::npos || dot == 0 || dot + 1 >= equals) {
    throw CallError(fmt::format(
        "--set {}: write MODULE.PARAMETER=VALUE, for example `--set learner.temperature=2`",
        setting));
  }
  try {
    Agent change = ParseAgent(fmt::format("modules.{} = {}", setting.substr(0, equals),
                                          TomlValue(setting.substr(equals + 1))),
                              "--set");
    const SourcePlace place{origin.empty() ? "--set " + setting : origin};
    for (ModuleSetting& module : change.modules) {
      module.place = place;
      for (ParameterSetting& parameter : module.parameters) parameter.place = place;
    }
    return change;
  } catch (const UserError&) {
    throw CallError(fmt::format(
        "--set {}: the value is none: write a number, true, false, \"text\" or [1, 2]", setting));
  }
}

Agent AgentLayers::Merge() const {
  Agent agent = ReadAgent(robot_file.parent_path() / "agent.toml");
  if (!start_pose.empty()) {
    agent = Changed(std::move(agent),
                    ParseSetting("environment.start_pose=" + start_pose, "start pose of the task"));
  }
  std::filesystem::path task_agent = task_file;
  task_agent.replace_extension(".agent.toml");
  if (std::filesystem::exists(task_agent)) agent = Changed(std::move(agent), ReadAgent(task_agent));
  if (!file.empty()) agent = Changed(std::move(agent), ReadAgent(file));
  if (!profile.empty()) {
    agent = Changed(std::move(agent),
                    ParseSetting("environment.profile=" + profile, "--profile " + profile));
  }
  for (const std::string& setting : settings) {
    agent = Changed(std::move(agent), ParseSetting(setting));
  }
  return agent;
}

}  // namespace runtime
