// How an experiment's metrics and reward terms went from episode to episode.
#pragma once

#include <string>
#include <vector>

#include "runtime/analysis/study/results.h"
#include "runtime/training/run/estimate.h"

namespace runtime {

// Of the moving averages of all runs, at the episodes of their Curves.
struct ValueCurve {
  std::string name;
  std::string unit;             // "" for a term
  std::vector<Estimate> means;  // over the runs that came as far and have the value
};

struct ValueCurves {
  std::vector<ValueCurve> metrics;
  std::vector<ValueCurve> terms;
};

// Those of any task of a run, in the order in which they first come. `episodes`: of CurvesOf().
ValueCurves ValueCurvesOf(const ExperimentResult& result, const std::vector<double>& episodes);

}  // namespace runtime
