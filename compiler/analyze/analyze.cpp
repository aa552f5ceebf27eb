#include "compiler/analyze/analyze.h"

#include "compiler/analyze/find_robot.h"
#include "compiler/check/check.h"
#include "compiler/syntax/parse.h"

namespace compiler {
namespace {

// True where the task has the robot that it needs; many need none.
bool GetRobot(Analysis& analysis, const std::filesystem::path& file,
              const std::filesystem::path& robots) {
  const auto& name = analysis.tree->robot;
  if (!name) return true;
  analysis.robot = FindRobot(*name, file, robots, analysis.diagnostics);
  return analysis.robot.has_value();
}

std::string TextOf(const std::filesystem::path& file, const FileReader& read) {
  std::optional<std::string> text = read(file);
  // Read again for the reason why it cannot be read.
  return text ? std::move(*text) : MustReadFromDisk(file);
}

}  // namespace

Analysis Analyze(const std::filesystem::path& file, const FileReader& read,
                 const std::filesystem::path& robots) {
  Analysis analysis{.sources = Sources(file.string(), TextOf(file, read)),
                    .tree = {},
                    .robot = {},
                    .diagnostics = {},
                    .task = {}};
  analysis.tree = Parse(analysis.sources.main(), analysis.diagnostics);
  if (!analysis.tree || !GetRobot(analysis, file, robots)) return analysis;
  analysis.task =
      Check(*analysis.tree, analysis.robot ? &*analysis.robot : nullptr, analysis.diagnostics);
  return analysis;
}

}  // namespace compiler
