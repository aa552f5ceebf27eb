#pragma once

#include <filesystem>

#include "runtime/analysis/preference/task_params.h"
#include "runtime/analysis/study/results.h"

namespace runtime {

// Asks on the terminal which of two groups of behaviors is better, pair by pair, until the user or
// the questions come to an end. Each answer is written down at once. Returns whether the user wants
// to go on with other experiments. `folder`: of the study.
bool AskPreferences(const StudyResults& study, const ExperimentResult& experiment,
                    const TaskParams& params, const std::filesystem::path& folder);

}  // namespace runtime
