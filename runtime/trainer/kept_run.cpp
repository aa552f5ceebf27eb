#include "runtime/trainer/kept_run.h"

#include "runtime/run/run_files.h"

namespace runtime {

KeptRun::KeptRun(const std::filesystem::path& folder, const RunRecord& run,
                 const std::filesystem::path& robot_folder, const ModuleTypes& program_types)
    : plugin(std::make_shared<const Plugin>(FindKeptPlugin(folder, run.tasks.front().plugin))),
      robot(ReadKeptRobot(robot_folder, run.robot_description)),
      context{&robot, plugin, run.seed},
      agent(ParseAgent(run.agent, (folder / "run.db").string() + ": agent")),
      types(WithComposites(program_types, agent)),
      network(BuildNetwork(agent, types, context)) {}

}  // namespace runtime
