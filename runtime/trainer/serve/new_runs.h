// What is to be done where a client asks for new runs.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "runtime/live/workers/supervisor.h"

namespace runtime {

struct NewRun {
  RunProgress progress;            // it waits
  std::vector<std::string> words;  // after `trainer`, by which a worker makes and trains it
};

// As `arguments` say (docs/api.md, `start`). Throws UserError where they say what cannot be;
// whether the task has errors its worker finds out.
std::vector<NewRun> NewRuns(const nlohmann::json& arguments, const std::filesystem::path& folder,
                            const std::filesystem::path& robots);

}  // namespace runtime
