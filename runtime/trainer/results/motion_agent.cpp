#include "runtime/trainer/results/motion_agent.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "runtime/base/user_error.h"
#include "runtime/trainer/results/learned_run.h"
#include "runtime/training/learning/motion_player.h"
#include "runtime/training/learning/motion_search.h"
#include "runtime/training/run/module_types.h"

namespace runtime {
namespace {

// What player and generator of a motion have in common.
constexpr std::array kShape = {
    "dof", "symmetry", "kind", "harmonics", "knots", "lowest_frequency", "highest_frequency"};

std::string Text(const std::filesystem::path& run, const RunRecord& record,
                 const MotionSearch& search, const MotionPlayer& player) {
  std::string text = fmt::format(
      "# PPO on top of a motion that brought {:.6g} in {} ({}, searched in {}).\n"
      "include = [\"ppo_on_motion\"]\n\n[modules.motion]\n",
      search.best_return(), record.tasks.back().task, record.profile, run.string());
  for (const char* parameter : kShape) {
    text += fmt::format("{} = {}\n", parameter, ToText(player.Get(parameter)));
  }
  const std::vector<double> best(search.best().begin(), search.best().end());
  return text + fmt::format("parameters = {}\n", ToText(best));
}

}  // namespace

std::string MotionAgent(const std::filesystem::path& run) {
  RunDatabase database = RunDatabase::OpenToRead(run);
  LearnedRun learned(run, database, "to learn on top of");
  Progress progress(ProgressStyle::kQuiet, learned.record, stdout, stderr);
  const StopRequest stop;
  const Performer performer(run, learned, database, learned.record.profile, progress, stop,
                            ProgramModuleTypes());
  const ModuleGraph& graph = performer.kept().graph;
  const std::vector<MotionSearch*> searches = graph.FindAll<MotionSearch>();
  const std::vector<MotionPlayer*> players = graph.FindAll<MotionPlayer>();
  if (searches.size() != 1 || players.size() != 1) {
    throw UserError(fmt::format(
        "{}: its agent has not searched for motions: train one with `--agent motion_search`",
        run.string()));
  }
  if (std::isnan(searches.front()->best_return())) {
    throw UserError(fmt::format(
        "{0}: it has not tried a motion yet: continue it with `trainer resume {0}`", run.string()));
  }
  return Text(run, learned.record, *searches.front(), *players.front());
}

}  // namespace runtime
