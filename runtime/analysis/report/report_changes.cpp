#include "runtime/analysis/report/report_changes.h"

#include <limits>
#include <map>
#include <set>

#include "runtime/analysis/report/base64.h"
#include "runtime/analysis/report/change_differences.h"
#include "runtime/training/run/task_spans.h"

namespace runtime {
namespace {

using nlohmann::json;

json Task(const TaskRecord& task) {
  json sources = json::array();
  for (const SourceRecord& source : task.sources) {
    sources.push_back({{"file", source.file}, {"text", source.text}});
  }
  return {{"module", task.module},
          {"name", task.task},
          {"file", task.task_file},
          {"hash", task.task_hash},
          {"sources", std::move(sources)}};
}

json Versions(const std::vector<EpisodeRecord>& episodes) {
  json versions = json::array();
  for (const TaskSpan& span : ActiveTasks(episodes)) {
    versions.push_back({{"task", span.task - 1}, {"first", span.first}, {"last", span.last}});
  }
  return versions;
}

json Shadows(const RunRecord& run, const std::vector<EpisodeRecord>& episodes) {
  struct Shadow {
    std::set<int64_t> tasks;  // indices
    std::vector<float> returns;
  };
  std::map<std::string, Shadow> by_module;
  for (size_t i = 0; i < episodes.size(); ++i) {
    for (const Evaluation& evaluation : episodes[i].shadows) {
      Shadow& shadow = by_module[TaskWithId(run, evaluation.task).module];
      shadow.tasks.insert(evaluation.task - 1);
      shadow.returns.resize(episodes.size(), std::numeric_limits<float>::quiet_NaN());
      shadow.returns[i] = static_cast<float>(evaluation.episode_return);
    }
  }
  json shadows = json::array();
  for (const auto& [module, shadow] : by_module) {
    shadows.push_back(
        {{"module", module}, {"tasks", shadow.tasks}, {"values", EncodeFloats(shadow.returns)}});
  }
  return shadows;
}

json Changes(const RunRecord& run, const std::vector<ChangeRecord>& records) {
  const std::vector<std::string> differences = ChangeDifferences(run, records);
  json changes = json::array();
  for (size_t i = 0; i < records.size(); ++i) {
    const ChangeRecord& change = records[i];
    changes.push_back({{"episode", change.episode},
                       {"step", change.step},
                       {"at", change.at},
                       {"kind", KindOf(change.change)},
                       {"text", change.text}});
    if (!differences[i].empty()) changes.back()["difference"] = differences[i];
  }
  return changes;
}

}  // namespace

void AddChanges(const RunRecord& run, const std::vector<EpisodeRecord>& episodes,
                const std::vector<ChangeRecord>& changes, json& data) {
  json& tasks = data["tasks"] = json::array();
  for (const TaskRecord& task : run.tasks) tasks.push_back(Task(task));
  data["versions"] = Versions(episodes);
  data["shadows"] = Shadows(run, episodes);
  data["changes"] = Changes(run, changes);
}

}  // namespace runtime
