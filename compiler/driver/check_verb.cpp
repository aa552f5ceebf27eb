// taskc check FILE.task...
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>

#include "compiler/bounds/bounds.h"
#include "compiler/bounds/bounds_table.h"
#include "compiler/driver/verb.h"
#include "compiler/mend/mend.h"
#include "compiler/source/file_reader.h"
#include "compiler/toolchain/file_io.h"

namespace compiler {
namespace {

struct CheckOptions {
  std::vector<std::string> tasks;
  bool shows_bounds = false;
  bool mends = false;
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

// "`bse` is now `base`"
std::string Describe(const Mended& mended) {
  if (mended.before.empty()) return fmt::format("inserted `{}`", mended.after);
  if (mended.after.empty()) return fmt::format("removed `{}`", mended.before);
  return fmt::format("`{}` is now `{}`", mended.before, mended.after);
}

Json ToJson(const Mended& mended) {
  return {{"file", mended.file}, {"line", mended.place.line}, {"column", mended.place.column},
          {"code", mended.code}, {"message", mended.message}, {"before", mended.before},
          {"text", mended.after}};
}

// Throws CallError where a file cannot be written, or is not what it was a moment ago.
void Save(const Mending& mending, const std::map<std::string, std::string>& read) {
  for (const auto& [file, text] : mending.texts) {
    if (MustReadFromDisk(file) != read.at(file))
      throw CallError(fmt::format("`{}` was changed meanwhile; nothing was written to it", file));
    RewriteFile(file, text);
  }
}

std::vector<Mended> MendFiles(const std::string& file, const Session& session) {
  std::map<std::string, std::string> texts;  // as they were read
  const auto read = [&](const std::filesystem::path& path) {
    std::optional<std::string> text = ReadFromDisk(path);
    if (text) texts.emplace(path.string(), *text);
    return text;
  };
  const Mending mending = Mend(file, read, session.robots, IsOwnFile);
  Save(mending, texts);
  for (const Mended& mended : mending.mended) {
    session.Say(fmt::format("{}:{}:{}: {} ({})\n", mended.file, mended.place.line,
                            mended.place.column, Describe(mended), mended.code));
  }
  return mending.mended;
}

ExitStatus CheckOne(const std::string& file, const CheckOptions& options, Session& session) {
  std::vector<Mended> mended;
  if (options.mends) mended = MendFiles(file, session);
  Analysis analysis = session.Analyze(file);
  if (options.mends) {
    Json& fixed = session.Result()["fixed"] = Json::array();
    for (const Mended& each : mended) fixed.push_back(ToJson(each));
  }
  if (!analysis.task) return ExitStatus::kWrongTask;
  session.Say(fmt::format("{}: ok ({})\n", file, Describe(*analysis.task)));
  Json& result = session.Result();
  result["sensors"] = analysis.task->sensors.size();
  result["terms"] = analysis.task->terms.size();
  result["ends"] = analysis.task->ends.size();
  if (options.shows_bounds) ShowBounds(*analysis.task, session);
  return ExitStatus::kOk;
}

}  // namespace

Action DeclareCheck(Command& command, Session& session) {
  auto options = std::make_shared<CheckOptions>();
  AddTasks(command, options->tasks);
  command.AddFlag("--bounds", options->shows_bounds,
                  "show the lowest and highest value that each reward, metric and log can take");
  command.AddFlag("--fix", options->mends,
                  "apply the fixes of errors to the files, and say what has changed");
  AddRobots(command, session);
  AddReport(command, session);
  return [options](Session& call) {
    return ForEachTask(options->tasks, call,
                       [&](const std::string& file) { return CheckOne(file, *options, call); });
  };
}

}  // namespace compiler
