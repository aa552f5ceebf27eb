// What came of judging runs by another task, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/trainer/rescore/rescore_runs.h"

namespace runtime {

// Each run with its episodes, then the runs in order if there are several, then the caveats.
std::string RescoreText(const std::string& new_task, const std::vector<RescoredRun>& runs);
nlohmann::ordered_json RescoreJson(const std::string& new_task,
                                   const std::vector<RescoredRun>& runs);

}  // namespace runtime
