#include "compiler/difference/task_outline.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "compiler/bounds/bounds.h"
#include "compiler/bounds/bounds_table.h"
#include "compiler/check/enumeration.h"
#include "compiler/check/unit.h"
#include "compiler/difference/expression_text.h"
#include "compiler/difference/statement_outline.h"
#include "compiler/syntax/words.h"
#include "plugins/robot/sensors.h"

namespace compiler {
namespace {

std::string RangeText(double low, double high, const Unit& unit) {
  const std::string name = ToString(unit);
  const auto end = [](double value) {
    return std::isfinite(value) ? fmt::format("{}", value + 0.0) : std::string("any");  // no -0
  };
  return fmt::format("{} .. {}{}{}", end(low), end(high), name.empty() ? "" : " ", name);
}

class Outliner {
 public:
  Outliner(const Analysis& analysis)
      : analysis_(analysis),
        task_(*analysis.task),
        enumerations_(EnumerationsOf(analysis.robot ? &*analysis.robot : nullptr)),
        writer_(task_, enumerations_) {}

  TaskOutline Outline() {
    AddTask();
    if (analysis_.world) AddWorld(*analysis_.world);
    AddStart();
    for (const CheckedParam& param : task_.params) AddParam(param);
    for (const CheckedSensor& sensor : task_.sensors) AddSensor(sensor);
    for (const CheckedTable& table : task_.tables) AddTable(table);
    for (const CheckedGoal& goal : task_.goals) AddGoal(goal);
    for (const CheckedObservation& observation : task_.observations) AddObservation(observation);
    for (size_t i = 0; i < task_.phases.size(); ++i) AddPhase(i);
    for (const CheckedMemory& memory : task_.memory) AddMemory(memory);
    for (const CheckedMetric& metric : task_.metrics) AddMetric(metric);
    for (const CheckedLogValue& log : task_.logs)
      Add("log", log.name, "of an episode", std::string(NameOf(log.reduction, kReductionNames)));
    StatementOutliner statements(task_, writer_, outline_);
    statements.AddEvent("start", task_.start.block);
    for (const auto& [name, event] : kEventNames)
      statements.AddEvent(std::string(name), task_.events[static_cast<size_t>(event)]);
    AddBounds();
    return std::move(outline_);
  }

 private:
  void Add(const std::string& kind, const std::string& name, const std::string& what,
           std::string text) {
    outline_.Part(kind, name).facts.push_back({what, std::move(text)});
  }

  void AddTask() {
    if (!task_.robot.empty()) Add("robot", "", "is", task_.robot);
    const bool can_end = !task_.ends.empty() || !task_.requirements.empty();
    if (can_end) Add("after_end", "", "is", task_.ended ? "stop" : "continue");
  }

  // What its ground is like is in its text alone.
  void AddWorld(const world::WorldDescription& world) {
    std::vector<std::string> things;
    for (const world::Thing& thing : world.things) things.push_back(thing.name);
    if (!things.empty()) Add("world", "", "things", fmt::format("{}", fmt::join(things, ", ")));
    const WorldFile& file = *analysis_.tree->world;
    std::string text;
    for (const std::optional<size_t>& index : {file.file, file.map_file})
      if (index) text += analysis_.sources.files()[*index].text();
    Add("world", "", "text", fmt::format("<{:x}>", std::hash<std::string>()(text)));
  }

  void AddStart() {
    if (!task_.start.poses.empty())
      Add("start", "", "poses", fmt::format("{}", fmt::join(task_.start.poses, " or ")));
  }

  void AddParam(const CheckedParam& param) {
    Add("param", param.name, "type", TypeText(param.type, param.unit));
    Add("param", param.name, "default", NumberWithUnit(param.initial, param.type, param.unit));
    if (param.type.scalar != Scalar::kBool)
      Add("param", param.name, "range", RangeText(param.minimum, param.maximum, param.unit));
  }

  // Those of a robot are no part of its tasks.
  void AddSensor(const CheckedSensor& sensor) {
    if (!task_.robot.empty() && robot::FindSensor(sensor.name) != nullptr) return;
    Add("sensor", sensor.name, "type", TypeText(sensor.type, sensor.unit));
    if (!sensor.minimum.empty())
      Add("sensor", sensor.name, "range",
          RangeText(std::ranges::min(sensor.minimum), std::ranges::max(sensor.maximum),
                    sensor.unit));
  }

  void AddTable(const CheckedTable& table) {
    Add("table", table.name, "type", TypeText(table.type, table.unit));
    Add("table", table.name, "argument",
        RangeText(table.arguments.front(), table.arguments.back(), table.argument_unit));
    const std::string numbers =
        fmt::format("{} {}", fmt::join(table.arguments, " "), fmt::join(table.elements, " "));
    Add("table", table.name, "numbers",
        fmt::format("{} rows, <{:x}>", table.arguments.size(), std::hash<std::string>()(numbers)));
  }

  void AddGoal(const CheckedGoal& goal) {
    Add("goal", goal.name, "type", TypeText(goal.type, goal.unit));
    Add("goal", goal.name, "value", writer_.Text(goal.value));
    Add("goal", goal.name, "lasts",
        goal.interval ? writer_.Text(goal.interval->length) : "an episode");
  }

  // A learner's net is made for these places.
  void AddObservation(const CheckedObservation& observation) {
    const Type& type = observation.value.type;
    Add("observation", observation.name, "type", TypeText(type, observation.value.unit));
    Add("observation", observation.name, "value", writer_.Text(observation.value));
    Add("observation", observation.name, "elements",
        fmt::format("{} .. {}", observation.offset, observation.offset + type.size() - 1));
    Add("observation", observation.name, "bounds",
        RangeText(observation.minimum, observation.maximum, observation.value.unit));
  }

  void AddPhase(size_t index) {
    const CheckedPhase& phase = task_.phases[index];
    Add("phase", phase.name, "index", fmt::format("{}", index));
    if (phase.limit)
      Add("phase", phase.name, "lasts at most",
          writer_.Text(phase.limit->time) + ", then " + task_.phases[phase.limit->otherwise].name);
  }

  void AddMemory(const CheckedMemory& memory) {
    if (!memory.is_declared) return;
    Add("memory", memory.name, "type", TypeText(memory.type, memory.unit));
    Add("memory", memory.name, "starts as", writer_.Text(memory.initial));
    Add("memory", memory.name, "per", std::string(NameOf(memory.scope, kScopeNames)));
  }

  void AddMetric(const CheckedMetric& metric) {
    Add("metric", metric.name, "value",
        TypeText(metric.value.type, metric.value.unit) + ", " + writer_.Text(metric.value));
    Add("metric", metric.name, "of an episode",
        std::string(NameOf(metric.reduction, kReductionNames)));
  }

  void AddBounds() {
    for (const BoundsRow& row : BoundsRows(task_, ComputeBounds(task_))) {
      const bool is_of_term = row.kind != "metric" && row.kind != "log";
      const std::string what = row.kind == "rate"      ? "bounds per second"
                               : row.kind == "payment" ? "bounds each time"
                                                       : "bounds";
      Add(is_of_term ? "term" : row.kind, row.name, what,
          HasNumber(row.value) ? RangeText(row.value.low, row.value.high, row.unit) : "never");
    }
  }

  const Analysis& analysis_;
  const CheckedTask& task_;
  const std::vector<Enumeration> enumerations_;
  ExpressionWriter writer_;
  TaskOutline outline_;
};

}  // namespace

OutlinePart& TaskOutline::Part(const std::string& kind, const std::string& name) {
  const auto found = std::ranges::find_if(
      parts, [&](const OutlinePart& part) { return part.kind == kind && part.name == name; });
  return found != parts.end() ? *found : parts.emplace_back(OutlinePart{kind, name, {}});
}

TaskOutline OutlineOf(const Analysis& analysis) { return Outliner(analysis).Outline(); }

}  // namespace compiler
