#include "runtime/trainer/runs/kept_run.h"

#include <fmt/format.h>

#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

// What `make` gives, from what the run's database says of its `part`. Whoever finds fault with
// that, in an `Error`, does not know where it is from.
template <class Error, class Make>
auto FromDatabase(const std::filesystem::path& folder, const char* part, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    throw UserError(
        fmt::format("{}: the table `run`: `{}`: {}; restore a copy of the file, use the trainer "
                    "that created the run, or start another run",
                    RunDatabaseFile(folder).string(), part, error.what()));
  }
}

// The agent's own types come from the copies of its libraries in the run's folder.
ModuleTypes TypesOf(const std::filesystem::path& folder, const Agent& agent,
                    const ModuleTypes& program_types) {
  Agent kept = agent;
  for (LibrarySetting& library : kept.libraries) {
    library.file = FindKeptPlugin(folder, library.file).string();
  }
  return WithComposites(WithLibraries(program_types, kept), kept);
}

}  // namespace

Agent AgentOfRun(const std::filesystem::path& folder, const RunRecord& run) {
  return FromDatabase<UserError>(folder, "agent", [&] { return ParseAgent(run.agent, "agent"); });
}

KeptRun::KeptRun(const std::filesystem::path& folder, const RunRecord& run,
                 const std::filesystem::path& robot_folder, const ModuleTypes& program_types)
    : plugin(std::make_shared<const Plugin>(FindKeptPlugin(folder, run.tasks.front().plugin))),
      robot(FromDatabase<robot::DescriptionError>(
          folder, "robot_description",
          [&] { return ReadKeptRobot(robot_folder, run.robot_description); })),
      context{&robot, plugin, run.seed},
      agent(AgentOfRun(folder, run)),
      types(TypesOf(folder, agent, program_types)),
      graph(FromDatabase<UserError>(folder, "agent",
                                    [&] { return BuildGraph(agent, types, context); })) {}

}  // namespace runtime
