// From a motion search to a policy that stands on what it has found.
#pragma once

#include <filesystem>
#include <string>

namespace runtime {

// An agent file for what learns on top of the best motion that the search in `run` had tried at its
// last checkpoint: the robot's agent `ppo_on_motion` with that motion. Throws UserError where the
// run is no motion search, or has nothing to show.
std::string MotionAgent(const std::filesystem::path& run);

}  // namespace runtime
