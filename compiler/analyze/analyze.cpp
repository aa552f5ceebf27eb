#include "compiler/analyze/analyze.h"

#include "compiler/analyze/allowances.h"
#include "compiler/analyze/find_robot.h"
#include "compiler/bounds/start_bounds.h"
#include "compiler/bounds/warnings.h"
#include "compiler/check/check.h"
#include "compiler/compose/compose.h"

namespace compiler {
namespace {

void GetRobot(Analysis& analysis, const std::filesystem::path& robots) {
  const auto& name = analysis.tree->robot;
  if (!name) return;
  const std::string& file = analysis.sources.FileOf(name->span).path();
  analysis.robot = FindRobot(*name, file, robots, analysis.diagnostics);
}

}  // namespace

Analysis Analyze(const std::filesystem::path& file, const FileReader& read,
                 const std::filesystem::path& robots, References* references) {
  Analysis analysis;
  analysis.tree = Compose(file, read, analysis.sources, analysis.diagnostics);
  if (!analysis.tree) return analysis;
  GetRobot(analysis, robots);
  analysis.task = Check(*analysis.tree, analysis.robot ? &*analysis.robot : nullptr,
                        analysis.diagnostics, references);
  if (!analysis.task) return analysis;
  CheckStops(*analysis.task, analysis.diagnostics);
  if (analysis.diagnostics.has_errors()) {
    analysis.task.reset();
    return analysis;
  }
  WarnOfBounds(*analysis.task, analysis.diagnostics);
  analysis.diagnostics =
      ApplyAllowances(analysis.tree->allowances, analysis.sources, analysis.diagnostics);
  return analysis;
}

}  // namespace compiler
