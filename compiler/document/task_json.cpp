#include "compiler/document/task_json.h"

#include <cmath>

#include "compiler/document/automaton.h"
#include "compiler/syntax/words.h"
#include "compiler/weights/weights.h"

namespace compiler {
namespace {

// A value of `param` as the task's text has it; null where it is infinite: there is no such end.
Json ValueOf(const CheckedParam& param, double value) {
  if (!std::isfinite(value)) return nullptr;
  switch (param.type.scalar) {
    case Scalar::kBool:
      return value != 0;
    case Scalar::kInt:
      return static_cast<int64_t>(value);
    case Scalar::kReal:
      break;
  }
  return value;
}

Json ToJson(const CheckedParam& param, const ParamUse& use, const CheckedTask& task) {
  const bool is_bool = param.type.scalar == Scalar::kBool;
  Json json = {{"name", param.name},
               {"doc", param.doc},
               {"type", ToString(param.type)},
               {"unit", ToString(param.unit)},
               {"default", ValueOf(param, param.initial)},
               {"least", is_bool ? Json() : ValueOf(param, param.minimum)},
               {"greatest", is_bool ? Json() : ValueOf(param, param.maximum)},
               {"scales", Json::array()},
               {"changes_course", use.changes_course}};
  for (const uint32_t term : use.scales) json["scales"].push_back(task.terms[term].name);
  return json;
}

Json ToJson(const CheckedTerm& term, std::optional<uint32_t> weight, const CheckedTask& task) {
  return {{"name", term.name},
          {"doc", term.doc},
          {"weight", weight ? Json(task.params[*weight].name) : Json()}};
}

Json ToJson(const CheckedMetric& metric) {
  return {{"name", metric.name},
          {"unit", ToString(metric.value.unit)},
          {"reduction", NameOf(metric.reduction, kReductionNames)},
          {"doc", metric.doc}};
}

Json ToJson(const CheckedObservation& observation) {
  const auto end = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  return {{"name", observation.name},
          {"type", ToString(observation.value.type)},
          {"unit", ToString(observation.value.unit)},
          {"offset", observation.offset},
          {"size", observation.value.type.size()},
          {"least", end(observation.minimum)},
          {"greatest", end(observation.maximum)},
          {"doc", observation.doc}};
}

// A phase with the ways out of it.
Json ToJson(uint32_t index, const std::vector<Transition>& transitions, const Analysis& analysis) {
  const CheckedPhase& phase = analysis.task->phases[index];
  Json json = {{"name", phase.name}, {"doc", phase.doc}, {"next", Json::array()}};
  for (const Transition& each : transitions) {
    if (each.from != index) continue;
    json["next"].push_back({{"phase", analysis.task->phases[each.to].name},
                            {"when", ConditionText(each, analysis)},
                            {"file", analysis.sources.FileOf(each.span).path()},
                            {"line", analysis.sources.LineOf(each.span)}});
  }
  return json;
}

Json ToJson(const CheckedGoal& goal) {
  return {{"name", goal.name},
          {"type", ToString(goal.type)},
          {"unit", ToString(goal.unit)},
          {"doc", goal.doc}};
}

Json ToJson(const CheckedTable& table) {
  return {{"name", table.name},
          {"type", ToString(table.type)},
          {"unit", ToString(table.unit)},
          {"doc", table.doc},
          {"file", table.file},
          {"rows", table.arguments.size()},
          {"argument",
           {{"name", table.argument},
            {"unit", ToString(table.argument_unit)},
            {"least", table.arguments.front()},
            {"greatest", table.arguments.back()}}}};
}

}  // namespace

Json ToJson(const Analysis& analysis) {
  const CheckedTask& task = *analysis.task;
  const SyntaxTree& tree = *analysis.tree;
  const Weights weights = FindWeights(task);
  Json json = {{"task", task.name},
               {"doc", task.doc},
               {"file", analysis.sources.main().path()},
               {"hash", analysis.sources.Hash()},
               {"robot", task.robot.empty() ? Json() : Json(task.robot)},
               {"world", tree.world ? Json(tree.world->path) : Json()},
               {"params", Json::array()},
               {"goals", Json::array()},
               {"tables", Json::array()},
               {"observations", Json::array()},
               {"phases", Json::array()},
               {"terms", Json::array()},
               {"metrics", Json::array()}};
  for (size_t i = 0; i < task.params.size(); ++i)
    json["params"].push_back(ToJson(task.params[i], weights.params[i], task));
  for (const CheckedGoal& goal : task.goals) json["goals"].push_back(ToJson(goal));
  for (const CheckedTable& table : task.tables) json["tables"].push_back(ToJson(table));
  for (const CheckedObservation& observation : task.observations)
    json["observations"].push_back(ToJson(observation));
  const std::vector<Transition> transitions = TransitionsOf(task);
  for (uint32_t i = 0; i < task.phases.size(); ++i)
    json["phases"].push_back(ToJson(i, transitions, analysis));
  for (size_t i = 0; i < task.terms.size(); ++i)
    json["terms"].push_back(ToJson(task.terms[i], weights.terms[i], task));
  for (const CheckedMetric& metric : task.metrics) json["metrics"].push_back(ToJson(metric));
  return json;
}

}  // namespace compiler
