// The learning curves of an experiment as a picture for documents.
#pragma once

#include <filesystem>

#include "runtime/study/results.h"

namespace runtime {

// Writes the curves of all runs, coloured by their groups, and their mean with its confidence
// interval to `file`, an SVG drawing. `curves`: those of `result`, of an episode at least. Throws
// UserError where gnuplot is missing or cannot write.
void PlotCurves(const ExperimentResult& result, const Curves& curves,
                const std::filesystem::path& file);

}  // namespace runtime
