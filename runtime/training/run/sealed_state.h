// The state of a checkpoint as the run's database holds it: with a hash by which damage is found.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace runtime {

// `state`, of the checkpoint after `episode`, after a hash of both.
std::string SealState(int64_t episode, const std::string& state);

// The state; nothing where it, or `episode`, is not what was sealed. A state from before there were
// hashes is taken as it is.
std::optional<std::string> UnsealState(int64_t episode, std::string sealed);

}  // namespace runtime
