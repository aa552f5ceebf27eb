// taskc check FILE.task...
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "compiler/bounds/bounds.h"
#include "compiler/bounds/bounds_table.h"
#include "compiler/driver/verb.h"

namespace compiler {
namespace {

struct CheckOptions {
  std::vector<std::string> tasks;
  bool shows_bounds = false;
};

std::string Describe(const CheckedTask& task) {
  auto count = [](size_t number, std::string_view what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
  };
  return fmt::format("{}, {}, {}", count(task.sensors.size(), "sensor"),
                     count(task.terms.size(), "term"), count(task.ends.size(), "end"));
}

Json ToJson(const BoundsRow& row) {
  const auto end = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  Json json = {{"name", row.name},
               {"kind", row.kind},
               {"low", end(row.value.low)},
               {"high", end(row.value.high)},
               {"unit", ToString(row.unit)},
               {"may_happen", !IsEmpty(row.value)},
               {"may_be_nan", row.value.may_be_nan}};
  json["unbounded_by"] = Json::array();
  for (const Cause& cause : row.causes) json["unbounded_by"].push_back(Describe(cause));
  return json;
}

void ShowBounds(const CheckedTask& task, Session& session) {
  const std::vector<BoundsRow> rows = BoundsRows(task, ComputeBounds(task));
  session.Say(ToTable(rows));
  Json& bounds = session.Result()["bounds"] = Json::array();
  for (const BoundsRow& row : rows) bounds.push_back(ToJson(row));
}

ExitStatus CheckOne(const std::string& file, bool shows_bounds, Session& session) {
  Analysis analysis = session.Analyze(file);
  if (!analysis.task) return ExitStatus::kWrongTask;
  session.Say(fmt::format("{}: ok ({})\n", file, Describe(*analysis.task)));
  Json& result = session.Result();
  result["sensors"] = analysis.task->sensors.size();
  result["terms"] = analysis.task->terms.size();
  result["ends"] = analysis.task->ends.size();
  if (shows_bounds) ShowBounds(*analysis.task, session);
  return ExitStatus::kOk;
}

}  // namespace

Action DeclareCheck(Command& command, Session& session) {
  auto options = std::make_shared<CheckOptions>();
  AddTasks(command, options->tasks);
  command.AddFlag("--bounds", options->shows_bounds,
                  "show the lowest and highest value that each reward, metric and log can take");
  AddRobots(command, session);
  AddReport(command, session);
  return [options](Session& call) {
    return ForEachTask(options->tasks, call, [&](const std::string& file) {
      return CheckOne(file, options->shows_bounds, call);
    });
  };
}

}  // namespace compiler
