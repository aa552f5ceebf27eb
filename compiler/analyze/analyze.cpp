#include "compiler/analyze/analyze.h"

#include "compiler/analyze/allowances.h"
#include "compiler/analyze/find_robot.h"
#include "compiler/analyze/find_world.h"
#include "compiler/bounds/bounds.h"
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

// The range of each observation is part of the task, for its hosts.
void KeepRanges(const TaskBounds& bounds, CheckedTask& task) {
  for (size_t i = 0; i < task.observations.size(); ++i) {
    const Interval& value = bounds.observations[i].value;
    if (!HasNumber(value)) continue;
    task.observations[i].minimum = value.low;
    task.observations[i].maximum = value.high;
  }
}

}  // namespace

Analysis Analyze(const std::filesystem::path& file, const FileReader& read,
                 const std::filesystem::path& robots, References* references) {
  Analysis analysis;
  analysis.tree = Compose(file, read, analysis.sources, analysis.diagnostics);
  if (!analysis.tree) return analysis;
  GetRobot(analysis, robots);
  analysis.world = FindWorld(*analysis.tree, read, analysis.sources, analysis.diagnostics);
  analysis.task =
      Check(*analysis.tree, analysis.robot ? &*analysis.robot : nullptr, analysis.diagnostics,
            references, analysis.world ? &*analysis.world : nullptr);
  if (!analysis.task) return analysis;
  CheckStops(*analysis.task, analysis.diagnostics);
  if (analysis.diagnostics.has_errors()) {
    analysis.task.reset();
    return analysis;
  }
  const TaskBounds bounds = ComputeBounds(*analysis.task);
  KeepRanges(bounds, *analysis.task);
  WarnOfBounds(*analysis.task, analysis.sources, bounds, analysis.diagnostics);
  analysis.diagnostics =
      ApplyAllowances(analysis.tree->allowances, analysis.sources, analysis.diagnostics);
  return analysis;
}

}  // namespace compiler
