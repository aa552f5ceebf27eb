// An agent as its file says it: modules, their parameters, and the connections between their ports.
//
//   connections = [["task.reward", "learner.reward"]]
//
//   [modules.learner]
//   type = "PengQLambda"
//   temperature = 5
//
// `libraries = ["lidar.so"]` brings types of modules that the trainer does not have.
// `include = ["base.toml"]` begins with what other files say, which lie beside it or come with the
// trainer ("robots/humanoid/agent.toml"), `include = ["ppo"]` with one of the robot's agents or,
// where it has none of this name, the one for any robot. `whole = true` says that the file is no
// change of another agent but an agent by itself. A composite is a type of module that is itself
// made of modules; it exports some of their ports and parameters:
//
//   [composites.DcobOverNet]
//   connections = [["net.net", "motion.net"]]
//   ports = {state = "motion.state", execute = "motion.execute"}
//   parameters = {net = "net.net"}
//
//   [composites.DcobOverNet.modules.net]
//   type = "NgNet"
//
// Everything keeps the place where it was written, for messages that appear when it is used.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/core/module/module.h"
#include "runtime/core/module/module_graph.h"

namespace runtime {

struct SourcePlace {
  std::string file;  // as messages name it; "" where nothing was written: a default
  int line = 0;      // from 1, like the column; 0 for what stands in no file
  int column = 0;

  // "agent.toml:3:12", "--set"
  std::string ToText() const;
};

struct ParameterSetting {
  std::string name;
  ParameterValue value;
  SourcePlace place;
};

struct ModuleSetting {
  std::string name;
  std::string type;  // "" in a file that changes a module of another file
  SourcePlace place;
  std::vector<ParameterSetting> parameters;
};

struct ConnectionSetting {
  std::string first;
  std::string second;
  SourcePlace place;
};

// A shared object with types of modules (runtime/core/module/module_library.h).
struct LibrarySetting {
  std::string file;
  SourcePlace place;
};

struct CompositeSetting;

struct Agent {
  bool is_whole = false;  // no change of another agent
  std::vector<LibrarySetting> libraries;
  std::vector<ModuleSetting> modules;  // in the order of their creation
  std::vector<ConnectionSetting> connections;
  std::vector<CompositeSetting> composites;  // each may use those before it
};

// `mind.reward` is `learner.reward` of the modules inside.
struct ExportSetting {
  std::string name;
  std::string inner;
  SourcePlace place;
};

struct CompositeSetting {
  std::string name;  // of the type
  SourcePlace place;
  Agent inside;  // without composites of its own
  std::vector<ExportSetting> ports;
  std::vector<ExportSetting> parameters;
};

// Reads an agent file and those that it includes. Throws UserError with file, line, column and, for
// a misspelled key, the nearest one. Whether types, parameters and ports exist is found out by
// BuildGraph.
//
// `robot_folder`: where files include the robot's agents from: "ppo" is ppo.agent.toml there.
Agent ReadAgent(const std::filesystem::path& file, const std::filesystem::path& robot_folder);

// Of an agent that comes with a robot: NAME.agent.toml beside its description.
constexpr std::string_view kAgentEnding = ".agent.toml";
// The folder of those that come with the trainer for any robot.
std::filesystem::path AgentsOfAnyRobot();
// Of those for tasks without a robot.
std::filesystem::path AgentsWithoutRobot();
// Whether this names a file, and not one of the robot's agents.
bool IsAgentFile(const std::string& agent);

// The same from a text, which cannot include; `name` stands for the file in messages.
Agent ParseAgent(std::string_view text, const std::string& name);

// `agent` with the changes of another file: parameters replace those of the same name, modules with
// a type of their own are added or replace the one of their name with all its parameters,
// connections, composites and libraries are added; a composite replaces one of its name. A whole
// agent takes the place of `agent`. Throws UserError for a change of a module that there is not.
Agent Changed(Agent agent, const Agent& changes);
// The same for two files that may both be changes of a third: what changes a module of neither is
// kept.
Agent Joined(Agent agent, const Agent& changes);

// `types` and those of the agent's libraries. Throws UserError, with the place in the agent file,
// where a library does not fit.
ModuleTypes WithLibraries(ModuleTypes types, const Agent& agent);
// `types` and the agent's own composites.
ModuleTypes WithComposites(ModuleTypes types, const Agent& agent);

// Makes the modules, sets their parameters and connects their ports. Throws UserError, with the
// place in the agent file, for whatever does not exist or does not fit.
ModuleGraph BuildGraph(const Agent& agent, const ModuleTypes& types, const Context& context);

// `agent` with the present values of all parameters of `graph`, which was built from it: nothing
// is left to defaults that another version of the program might change.
Agent Resolved(const Agent& agent, const ModuleGraph& graph);

// As an agent file. The same agent gives the same text, byte for byte, and reading it gives the
// same agent.
std::string ToToml(const Agent& agent);
// The same with a comment after each line that says where it comes from.
std::string ToTomlWithPlaces(const Agent& agent);

}  // namespace runtime
