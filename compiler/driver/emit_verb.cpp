// taskc emit FILE.task
#include <fmt/format.h>

#include <memory>

#include "compiler/build/file_io.h"
#include "compiler/driver/verb.h"
#include "compiler/emit/emit.h"

namespace compiler {
namespace {

struct Options {
  std::string task;
  std::filesystem::path output;  // empty: standard output
};

ExitStatus EmitOne(const Options& options, Session& session) {
  Analysis analysis = session.Analyze(options.task);
  if (!analysis.task) return ExitStatus::kWrongTask;
  std::string cpp = Emit(*analysis.task, analysis.sources);
  if (options.output.empty()) {
    fmt::print("{}", cpp);
  } else {
    ReplaceFile(options.output, cpp);
  }
  return ExitStatus::kOk;
}

}  // namespace

Action DeclareEmit(CLI::App& app, Session& session) {
  auto options = std::make_shared<Options>();
  AddTask(app, options->task);
  AddOutput(app, options->output, "FILE.cpp", "the C++ file; without, it is printed");
  AddRobots(app, session);
  return [options](Session& call) { return EmitOne(*options, call); };
}

}  // namespace compiler
