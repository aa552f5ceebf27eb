// The replays and pictures of a study's page: the final behavior of each group's typical run.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/analysis/study/results.h"

namespace runtime {

// Sets `recording` and `strip` of each group in `experiments`, the page's data of `results`:
// {episode, frames, interval, poses} and {times, png}. So that the page stays below a fixed size,
// up to three of four frames are left out, and then both for the smallest groups; `notes` says so.
void AddGroupRecordings(const std::vector<ExperimentResult>& results, nlohmann::json& experiments,
                        std::vector<std::string>& notes);

}  // namespace runtime
