// The agents of a robot: NAME.agent.toml beside its robot.toml is its agent `NAME`, for `--agent
// NAME`. Where it has none of a name, one that comes with the trainer for any robot is its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace runtime {

struct AgentPreset {
  std::string name;
  std::string doc;  // the first line of the file, if that is a comment
  std::filesystem::path file;
};

// The agent of a robot that has no agent.toml.
inline constexpr const char* kAgentOfAnyRobot = "ppo";

// In alphabetical order.
std::vector<AgentPreset> AgentPresetsOf(const std::filesystem::path& robot_folder);

// What `--agent` names: one of the robot's agents or, where there is a '/' in it or ".toml" at its
// end, a file. "" for none. Throws CallError where there is neither.
std::filesystem::path FindAgentFile(const std::string& agent,
                                    const std::filesystem::path& robot_folder);

}  // namespace runtime
