#include "fuzz/targets.h"

#include "compiler/check/check.h"
#include "compiler/compose/compose.h"
#include "compiler/emit/emit.h"
#include "compiler/format/format.h"
#include "compiler/interpret/evaluator.h"
#include "compiler/source/sources.h"
#include "compiler/syntax/parse.h"
#include "fuzz/corpus.h"

namespace fuzz {
namespace {

using compiler::CheckedTask;
using compiler::Diagnostics;
using compiler::Sources;

const robot::RobotDescription& Humanoid() {
  static const robot::RobotDescription robot =
      robot::ReadRobot(SOURCE_DIR "/plugins/humanoid/robot.toml");
  return robot;
}

void Show(const Sources& sources, const Diagnostics& diagnostics) {
  for (const compiler::Diagnostic& diagnostic : diagnostics.list()) {
    Require(diagnostic.span.begin <= diagnostic.span.end, "a place ends before it begins");
    Require(diagnostic.span.end <= sources.files().back().end_offset(),
            "a place is behind the text");
    Require(!diagnostic.message.empty(), "a diagnostic says nothing");
  }
  Require(Render(sources, diagnostics, false).empty() == diagnostics.list().empty(),
          "diagnostics are not shown");
}

void Use(const CheckedTask& task, const Sources& sources) {
  Require(!Emit(task, sources).empty(), "nothing is emitted");
  compiler::Evaluator evaluator(task);
  for (int event = 0; event < 8; ++event) {
    evaluator.Fire(static_cast<compiler::EventKind>(event), 0.005);
    evaluator.Measure();
  }
}

}  // namespace

bool Parse(const std::string& text) {
  const Sources sources("fuzz.task", text);
  Diagnostics diagnostics;
  const auto tree = compiler::Parse(sources.main(), diagnostics);
  Require(tree || diagnostics.has_errors(), "neither a tree nor an error");
  Require(!tree || tree->lost.is_empty() || diagnostics.has_errors(), "something is lost silently");
  Show(sources, diagnostics);
  return !diagnostics.has_errors();
}

bool Check(const std::string& text) {
  const auto read = [&](const std::filesystem::path& file) {
    return file == "fuzz.task" ? std::optional(text) : std::nullopt;
  };
  Sources sources;
  Diagnostics diagnostics;
  const auto tree = compiler::Compose("fuzz.task", read, sources, diagnostics);
  if (!tree) return false;
  const auto task = compiler::Check(*tree, tree->robot ? &Humanoid() : nullptr, diagnostics);
  Require(task.has_value() == !diagnostics.has_errors(), "neither a task nor an error, or both");
  Show(sources, diagnostics);
  if (task) Use(*task, sources);
  return task.has_value();
}

// A task whose only table is read, of each kind.
bool Table(const std::string& text) {
  struct Kind {
    const char* type;
    const char* value;
  };
  constexpr Kind kKinds[] = {{"real [m]", "a(time, loop) / 1 m"},
                             {"vec3 [m]", "norm(a(time)) / 1 m"},
                             {"quat", "a(time).w"},
                             {"real[joint] [rad]", "norm(a(time, loop)) / 1 rad"}};
  bool is_one = false;
  for (const Kind& kind : kKinds) {
    const std::string task =
        std::string("task fuzz for humanoid\ntable a: ") + kind.type +
        " = \"fuzz.csv\"\non end_of_time_step { reward rate b = " + kind.value + " }\n";
    const auto read = [&](const std::filesystem::path& file) {
      return file == "fuzz.csv" ? text : task;
    };
    Sources sources;
    Diagnostics diagnostics;
    const auto tree = compiler::Compose("fuzz.task", read, sources, diagnostics);
    Require(tree.has_value(), "a table makes its task unreadable");
    const auto checked = compiler::Check(*tree, &Humanoid(), diagnostics);
    Require(checked.has_value() == !diagnostics.has_errors(),
            "neither a task nor an error, or both");
    Show(sources, diagnostics);
    if (checked) Use(*checked, sources);
    is_one = is_one || checked.has_value();
  }
  return is_one;
}

bool Format(const std::string& text) {
  Diagnostics diagnostics;
  const Sources sources("fuzz.task", text);
  const auto formatted = compiler::Format(sources.main(), diagnostics);
  Require(formatted.has_value() == !diagnostics.has_errors(), "neither a text nor an error");
  if (!formatted) return false;
  const Sources again("fuzz.task", *formatted);
  const auto twice = compiler::Format(again.main(), diagnostics);
  Require(twice.has_value(), "formatting made a mistake");
  Require(*twice == *formatted, "a formatted text is formatted otherwise");
  return true;
}

const std::vector<Target>& Targets() {
  static const std::vector<Target> targets = {
      {"parse", Parse, TaskTexts, TaskWords},
      {"check", Check, TaskTexts, TaskWords},
      {"format", Format, TaskTexts, TaskWords},
      {"table", Table, TableTexts, TableWords},
  };
  return targets;
}

}  // namespace fuzz
