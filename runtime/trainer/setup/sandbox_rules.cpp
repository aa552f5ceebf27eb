#include "runtime/trainer/setup/sandbox_rules.h"

#include <stdlib.h>

#include <algorithm>
#include <optional>
#include <string>
#include <system_error>
#include <variant>

#include "base/cache/cache_folder.h"
#include "runtime/training/environment/socket_environment.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

void AddFilesNamedIn(const Agent& agent, std::vector<fs::path>& files) {
  for (const LibrarySetting& library : agent.libraries) files.emplace_back(library.file);
  for (const ModuleSetting& module : agent.modules) {
    for (const ParameterSetting& parameter : module.parameters) {
      const auto* text = std::get_if<std::string>(&parameter.value);
      std::error_code ignored;
      if (text != nullptr && fs::is_regular_file(*text, ignored)) files.emplace_back(*text);
    }
  }
  for (const CompositeSetting& composite : agent.composites) {
    AddFilesNamedIn(composite.inside, files);
  }
}

bool TalksToAProgram(const Agent& agent) {
  return std::ranges::any_of(
             agent.modules,
             [](const ModuleSetting& module) { return module.type == SocketEnvironment::kType; }) ||
         std::ranges::any_of(agent.composites, [](const CompositeSetting& composite) {
           return TalksToAProgram(composite.inside);
         });
}

SandboxRules RulesOf(const Agent& agent) {
  SandboxRules rules{.files = {}, .may_connect = TalksToAProgram(agent)};
  AddFilesNamedIn(agent, rules.files.readable);
  if (const std::optional<fs::path> nets = cache::NetFolder()) {
    std::error_code ignored;  // a cache that cannot be had costs time only
    fs::create_directories(*nets, ignored);
    rules.files.writable.push_back(*nets);
  }
  return rules;
}

SandboxRules With(SandboxRules rules, const fs::path& folder) {
  rules.files.writable.insert(rules.files.writable.begin(), folder);
  return rules;
}

}  // namespace

void AddSandboxOption(command_line::Command& command) {
  command.OnFlag("--no-sandbox", DoWithoutSandbox,
                 "let the code of tasks and modules reach all files and the network, as you can");
}

SandboxRules RulesOf(const Agent& agent, const fs::path& folder) {
  return With(RulesOf(agent), folder);
}

SandboxRules RulesOf(const TaskSetup& known, const fs::path& folder) {
  return With(RulesOf(known), folder);
}

SandboxRules RulesOf(const TaskSetup& known) {
  SandboxRules rules = RulesOf(known.agent);
  rules.files.readable.push_back(known.plugin_file);
  if (!known.robot_file.empty()) rules.files.readable.push_back(known.robot_file.parent_path());
  return rules;
}

TaskSetup SetUpInSandbox(const TaskOptions& options, const fs::path& plugin, uint64_t seed,
                         const std::optional<fs::path>& folder) {
  return TaskSetup(options, plugin, seed, ProgramModuleTypes(), [&](const TaskSetup& known) {
    EnterSandbox(folder ? RulesOf(known, *folder) : RulesOf(known));
  });
}

CommandSandbox::CommandSandbox(SandboxRules rules) {
  WarnWhereSandboxIsWeak();
  rules.files.tidied = {fs::temp_directory_path()};
  rules.files.writable.push_back(temporary_.path());
  setenv("TMPDIR", temporary_.path().c_str(), 1);
  EnterSandbox(rules);
}

}  // namespace runtime
