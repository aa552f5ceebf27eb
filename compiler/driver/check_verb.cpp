// taskc check FILE.task...
#include <fmt/format.h>

#include <memory>

#include "compiler/driver/verb.h"

namespace compiler {
namespace {

struct Options {
  std::vector<std::string> tasks;
};

std::string Describe(const CheckedTask& task) {
  auto count = [](size_t number, std::string_view what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
  };
  return fmt::format("{}, {}, {}", count(task.sensors.size(), "sensor"),
                     count(task.terms.size(), "term"), count(task.ends.size(), "end"));
}

ExitStatus CheckOne(const std::string& file, Session& session) {
  Analysis analysis = session.Analyze(file);
  if (!analysis.task) return ExitStatus::kWrongTask;
  session.Say(fmt::format("{}: ok ({})\n", file, Describe(*analysis.task)));
  Json& result = session.Result();
  result["sensors"] = analysis.task->sensors.size();
  result["terms"] = analysis.task->terms.size();
  result["ends"] = analysis.task->ends.size();
  return ExitStatus::kOk;
}

// A file that cannot be read does not keep the others from being checked.
ExitStatus Check(const Options& options, Session& session) {
  ExitStatus status = ExitStatus::kOk;
  for (const std::string& file : options.tasks) {
    try {
      status = Worse(status, CheckOne(file, session));
    } catch (const CallError& error) {
      session.Fail(error.what());
      status = Worse(status, ExitStatus::kWrongCall);
    }
  }
  return status;
}

}  // namespace

Action DeclareCheck(CLI::App& app, Session& session) {
  auto options = std::make_shared<Options>();
  AddTasks(app, options->tasks);
  AddRobots(app, session);
  AddReport(app, session);
  return [options](Session& call) { return Check(*options, call); };
}

}  // namespace compiler
