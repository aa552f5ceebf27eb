#include "runtime/trainer/engines/study_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "runtime/base/user_error.h"
#include "runtime/live/workers/run_table.h"
#include "runtime/trainer/runs/many_runs.h"

namespace runtime {
namespace {

std::string LowerCase(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string PlaceText(const RunStatus& run) {
  if (run.progress.state == RunProgressState::kFailed) return run.progress.failure;
  if (!run.task || run.progress.is_over()) return "";
  if (!run.is_in_queue) return fmt::format("its last task ended as {}", run.task->state);
  return run.task->node.empty() ? run.task->reason : run.task->node;
}

}  // namespace

std::vector<RunStatus> ReadStudyStatus(const std::filesystem::path& folder) {
  const std::vector<SlurmArray> arrays = ReadSlurmArrays(folder);
  const SlurmTasks queued = QueuedTasks(arrays);
  const SlurmTasks ended = EndedTasks(arrays);
  std::vector<RunStatus> runs;
  for (RunProgress& progress : ReadProgressOrFailures(folder, FindRuns(folder))) {
    RunStatus& status = runs.emplace_back(std::move(progress));
    const auto find = [&](const SlurmTasks& tasks) {
      const auto found = tasks.find(status.progress.name);
      if (found != tasks.end()) status.task = found->second;
      return found != tasks.end();
    };
    status.is_in_queue = find(queued);
    if (!status.is_in_queue) find(ended);
  }
  if (runs.empty()) {
    throw UserError(
        fmt::format("{}: there are no runs in this folder; `trainer study FILE --out "
                    "{}` makes them",
                    folder.string(), folder.string()));
  }
  return runs;
}

std::string StateText(const RunStatus& run) {
  if (run.progress.is_over() || !run.is_in_queue) return std::string(NameOf(run.progress.state));
  return LowerCase(run.task->state);
}

std::string StatusText(const std::vector<RunStatus>& runs) {
  size_t name_width = 3;
  size_t state_width = 5;
  for (const RunStatus& run : runs) {
    name_width = std::max(name_width, run.progress.name.size());
    state_width = std::max(state_width, StateText(run).size());
  }
  std::string text;
  const auto add = [&](const std::string& name, const std::string& state,
                       const std::string& episodes, const std::string& where) {
    text += fmt::format("{:<{}}  {:<{}}  {:>11}  {}", name, name_width, state, state_width,
                        episodes, where);
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  };
  add("run", "state", "episodes", "node or reason");
  std::map<std::string, int> counts;
  for (const RunStatus& run : runs) {
    add(run.progress.name, StateText(run),
        fmt::format("{}/{}", run.progress.episodes, run.progress.episodes_planned), PlaceText(run));
    ++counts[StateText(run)];
  }
  std::string summary;
  for (const auto& [state, count] : counts) {
    summary += fmt::format("{}{} {}", summary.empty() ? "" : ", ", count, state);
  }
  return text + summary + "\n";
}

nlohmann::ordered_json StatusJson(const std::vector<RunStatus>& runs) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const RunStatus& run : runs) {
    json.push_back({{"run", run.progress.name},
                    {"state", StateText(run)},
                    {"episodes", run.progress.episodes},
                    {"episodes_planned", run.progress.episodes_planned},
                    {"task", nullptr}});
    if (!run.task) continue;
    json.back()["task"] = {{"state", run.task->state},
                           {"node", run.task->node},
                           {"reason", run.task->reason},
                           {"is_in_queue", run.is_in_queue}};
  }
  return json;
}

}  // namespace runtime
