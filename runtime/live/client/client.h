// A client of a running trainer, over the Unix socket in its run's folder. Each call waits for as
// long as the trainer takes.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "runtime/live/control/request.h"

namespace runtime {

// Whether a trainer listens in this folder.
bool HasTrainer(const std::filesystem::path& folder);

// Throws UserError where no trainer answers, or where it ends before it has replied.
Reply Ask(const std::filesystem::path& folder, const Request& request);

// Calls `take` with each event from now on, until the trainer ends. Throws UserError where none
// answers.
void FollowEvents(const std::filesystem::path& folder,
                  const std::function<void(const nlohmann::json&)>& take);

}  // namespace runtime
