// taskc emit FILE.task
#include <fmt/format.h>

#include <memory>

#include "compiler/driver/verb.h"
#include "compiler/emit/emit.h"
#include "compiler/emit/line_map.h"
#include "compiler/toolchain/file_io.h"

namespace compiler {
namespace {

struct EmitOptions {
  std::string task;
  std::filesystem::path output;  // empty: standard output
  bool map = false;
};

ExitStatus EmitOne(const EmitOptions& options, Session& session) {
  Analysis analysis = session.Analyze(options.task);
  if (!analysis.task) return ExitStatus::kWrongTask;
  EmittedText cpp = EmitWithOrigins(*analysis.task, analysis.sources);
  std::string text = options.map ? LineMap(cpp.origins) : cpp.text;
  if (options.output.empty()) {
    fmt::print("{}", text);
  } else {
    ReplaceFile(options.output, text);
  }
  return ExitStatus::kOk;
}

}  // namespace

Action DeclareEmit(Command& command, Session& session) {
  auto options = std::make_shared<EmitOptions>();
  AddTask(command, options->task);
  AddOutput(command, options->output, "FILE.cpp",
            "where to write the C++; otherwise it is printed");
  command.AddFlag("--map", options->map,
                  "print which C++ lines each line of the task compiles to, instead of the C++");
  AddRobots(command, session);
  return [options](Session& call) { return EmitOne(*options, call); };
}

}  // namespace compiler
