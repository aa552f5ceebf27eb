// taskc test FILE.task...
#include <fmt/format.h>

#include <memory>

#include "compiler/driver/verb.h"
#include "compiler/task_tests/test_task.h"
#include "compiler/toolchain/plugin_cache.h"

namespace compiler {
namespace {

struct TestOptions {
  std::vector<std::string> tasks;
  std::string filter;           // empty: all tests
  std::filesystem::path cache;  // empty: the default
};

Json ToJson(const Failure& failure, const Sources& sources) {
  Json values = Json::array();
  for (const SeenValue& seen : failure.values) {
    const std::string_view written = sources.FileOf(seen.span).TextOf(seen.span);
    values.push_back({{"expression", seen.name.empty() ? written : std::string_view(seen.name)},
                      {"value", seen.value}});
  }
  return {{"file", sources.FileOf(failure.span).path()},
          {"line", sources.LineOf(failure.span)},
          {"statement", sources.FileOf(failure.span).TextOf(failure.span)},
          {"message", failure.message},
          {"values", values}};
}

Json ToJson(const TestReport& report, const Sources& sources) {
  Json tests = Json::array();
  for (const TestResult& result : report.results) {
    Json failures = Json::array();
    for (const Failure& failure : result.failures) failures.push_back(ToJson(failure, sources));
    tests.push_back({{"name", result.name},
                     {"line", sources.LineOf(result.span)},
                     {"passed", result.passed()},
                     {"failures", failures}});
  }
  return tests;
}

std::string Summary(const std::string& file, const TestReport& report) {
  const size_t count = report.results.size();
  if (count == 0) return fmt::format("{}: no tests\n", file);
  return fmt::format("{}: {} test{}, {}\n", file, count, count == 1 ? "" : "s",
                     report.failed() == 0 ? "all ok" : fmt::format("{} failed", report.failed()));
}

ExitStatus TestOne(const std::string& file, const TestOptions& options, Session& session) {
  Analysis analysis = session.Analyze(file);
  if (!analysis.task) return ExitStatus::kWrongTask;
  const TestReport report = TestTask(*analysis.task, analysis.sources, options.filter,
                                     options.cache.empty() ? DefaultCacheFolder() : options.cache);
  session.Say(ToText(report, analysis.sources) + Summary(file, report));
  session.Result()["tests"] = ToJson(report, analysis.sources);
  return report.failed() == 0 ? ExitStatus::kOk : ExitStatus::kWrongTask;
}

}  // namespace

Action DeclareTest(Command& command, Session& session) {
  auto options = std::make_shared<TestOptions>();
  AddTasks(command, options->tasks);
  command.AddOption("--filter", options->filter, "run only tests whose names contain this")
      .ValueName("NAME");
  command.AddOption("--cache", options->cache, "folder for built plugins").ValueName("DIR");
  AddRobots(command, session);
  AddReport(command, session);
  return [options](Session& call) {
    return ForEachTask(options->tasks, call,
                       [&](const std::string& file) { return TestOne(file, *options, call); });
  };
}

}  // namespace compiler
