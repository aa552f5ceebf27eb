#include "runtime/live/control/replies.h"

#include <fmt/format.h>

#include "runtime/base/suggestion.h"
#include "runtime/core/module/graph_text.h"
#include "runtime/core/module/layout_text.h"
#include "runtime/live/control/parameter_json.h"
#include "runtime/live/control/versions.h"

namespace runtime {
namespace {

nlohmann::json AllParameters(const Module& module) {
  nlohmann::json parameters = nlohmann::json::array();
  for (const Parameter& parameter : module.parameters()) {
    parameters.push_back(ParameterJson(module, parameter));
  }
  return parameters;
}

nlohmann::json TermsJson(const UniversalTask& task) {
  nlohmann::json terms = nlohmann::json::object();
  for (size_t i = 0; i < task.term_sums().size(); ++i) {
    terms[task.plugin().terms[i].name] = task.term_sums()[i];
  }
  return terms;
}

nlohmann::json GoalsJson(const UniversalTask& task) {
  nlohmann::json goals = nlohmann::json::array();
  const TaskGoals& all = task.instance().goals();
  for (size_t i = 0; i < all.goals().size(); ++i) {
    const taskc_goal& goal = all.goals()[i];
    goals.push_back({{"name", fmt::format("{}.{}", task.name(), goal.name)},
                     {"value", all.Value(i)},
                     {"unit", goal.unit},
                     {"held", all.IsHeld(i)},
                     {"doc", goal.doc}});
  }
  return goals;
}

// What each phase is in the current episode.
nlohmann::json PhasesJson(const TaskPhases& all) {
  nlohmann::json phases = nlohmann::json::array();
  for (size_t i = 0; i < all.phases().size(); ++i) {
    phases.push_back({{"name", all.phases()[i].name},
                      {"present", i == all.present()},
                      {"time", all.sums()[i].time},
                      {"return", all.sums()[i].reward},
                      {"doc", all.phases()[i].doc}});
  }
  return phases;
}

nlohmann::json TaskModuleJson(const UniversalTask& task, const RunRecord& run) {
  const TaskRecord& record = TaskWithId(run, task.instance().id());
  nlohmann::json json = TaskJson(task.name(), record);
  json["file"] = record.task_file;
  json["role"] = RoleName(task);
  json["previous"] = nullptr;
  if (task.previous() != nullptr) {
    json["previous"] = TaskJson(task.name(), TaskWithId(run, task.previous()->id()));
  }
  json["versions"] = VersionsJson(run, task.name());
  json["params"] = AllParameters(task);
  json["goals"] = GoalsJson(task);
  json["observations"] = ToJson(task.observation_layout());
  json["phases"] = PhasesJson(task.instance().phases());
  json["return"] = task.episode_return();
  json["terms"] = TermsJson(task);
  return json;
}

}  // namespace

const char* RoleName(const UniversalTask& task) { return task.is_shadow() ? "shadow" : "active"; }

nlohmann::json TaskJson(const std::string& module, const TaskRecord& task) {
  return {{"module", module}, {"task", task.task}, {"hash", task.task_hash}};
}

nlohmann::json ListJson(const LiveGraph& graph, const Schedules& schedules, const RunRecord& run) {
  nlohmann::json list = {{"tasks", nlohmann::json::array()},
                         {"modules", nlohmann::json::array()},
                         {"schedules", nlohmann::json::array()}};
  for (const auto& module : graph.graph().modules()) {
    list["modules"].push_back(
        {{"name", module->name()}, {"started", graph.WhyNotStarted(module->name()).empty()}});
    const auto* task = dynamic_cast<const UniversalTask*>(module.get());
    if (task != nullptr) list["tasks"].push_back(TaskModuleJson(*task, run));
  }
  for (const auto& [name, schedule] : schedules.all()) {
    list["schedules"].push_back({{"name", name},
                                 {"from", schedule.from},
                                 {"to", schedule.to},
                                 {"first_episode", schedule.first_episode},
                                 {"episodes", schedule.episodes}});
  }
  return list;
}

nlohmann::json ParametersJson(const LiveGraph& graph, const std::string& name) {
  const size_t dot = name.find('.');
  const Module& module = graph.graph().Find(name.substr(0, dot));
  if (dot == std::string::npos) return AllParameters(module);
  return ParameterJson(module, module.FindParameter(name.substr(dot + 1)));
}

nlohmann::json GraphReply(const LiveGraph& graph, const std::string& format) {
  if (format == "text") return {{"text", GraphText(graph.graph())}};
  if (format == "json") return {{"text", GraphJson(graph.graph())}};
  if (format == "dot") return {{"text", GraphDot(graph.graph())}};
  throw UserError(
      fmt::format("`{}` is not a format{}", format, Suggestion(format, {"text", "json", "dot"})));
}

}  // namespace runtime
