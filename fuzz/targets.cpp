#include "fuzz/targets.h"

#include <cstdio>
#include <cstdlib>

#include "compiler/check/check.h"
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
using compiler::SyntaxTree;

void Require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "fuzz: %s\n", what);
  std::abort();
}

const robot::RobotDescription& Humanoid() {
  static const robot::RobotDescription robot =
      robot::ReadRobot(SOURCE_DIR "/plugins/humanoid/robot.toml");
  return robot;
}

void Show(const Sources& sources, const Diagnostics& diagnostics) {
  for (const compiler::Diagnostic& diagnostic : diagnostics.list()) {
    Require(diagnostic.span.begin <= diagnostic.span.end, "a place ends before it begins");
    Require(diagnostic.span.end <= sources.main().end_offset(), "a place is behind the text");
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

void Parse(const std::string& text) {
  const Sources sources("fuzz.task", text);
  Diagnostics diagnostics;
  const auto tree = compiler::Parse(sources.main(), diagnostics);
  Require(tree || diagnostics.has_errors(), "neither a tree nor an error");
  Require(!tree || tree->lost.is_empty() || diagnostics.has_errors(), "something is lost silently");
  Show(sources, diagnostics);
}

void Check(const std::string& text) {
  const Sources sources("fuzz.task", text);
  Diagnostics diagnostics;
  const std::optional<SyntaxTree> tree = compiler::Parse(sources.main(), diagnostics);
  if (!tree) return;
  const auto task = compiler::Check(*tree, tree->robot ? &Humanoid() : nullptr, diagnostics);
  Require(task.has_value() == !diagnostics.has_errors(), "neither a task nor an error, or both");
  Show(sources, diagnostics);
  if (task) Use(*task, sources);
}

void Format(const std::string& text) {
  Diagnostics diagnostics;
  const Sources sources("fuzz.task", text);
  const auto formatted = compiler::Format(sources.main(), diagnostics);
  Require(formatted.has_value() == !diagnostics.has_errors(), "neither a text nor an error");
  if (!formatted) return;
  const Sources again("fuzz.task", *formatted);
  const auto twice = compiler::Format(again.main(), diagnostics);
  Require(twice.has_value(), "formatting made a mistake");
  Require(*twice == *formatted, "a formatted text is formatted otherwise");
}

const std::vector<Target>& Targets() {
  static const std::vector<Target> targets = {
      {"parse", Parse, TaskTexts, TaskWords},
      {"check", Check, TaskTexts, TaskWords},
      {"format", Format, TaskTexts, TaskWords},
  };
  return targets;
}

const Target& FindTarget(std::string_view name) {
  for (const Target& target : Targets()) {
    if (target.name == name) return target;
  }
  std::fprintf(stderr, "fuzz: there is no target of this name\n");
  std::exit(2);
}

}  // namespace fuzz
