// The learning curves of an experiment as a picture for documents.
#pragma once

#include <string>

#include "runtime/analysis/study/results.h"

namespace runtime {

// The curves of all runs, colored by their groups, and their mean with its confidence interval, as
// SVG. `curves`: those of `result`, of an episode at least. Throws UserError where gnuplot is
// missing or fails.
std::string DrawCurves(const ExperimentResult& result, const Curves& curves);

}  // namespace runtime
