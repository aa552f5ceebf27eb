// The episodes of a run as an event file of TensorBoard.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/analysis/export/episode_table.h"

namespace runtime {

// A name that TensorBoard finds in a run's folder.
inline constexpr const char* kEventFile = "events.out.tfevents.taskc";

// Each column is a scalar with its name as the tag, each episode a step with its number; what is
// not a number is left out.
std::string TensorBoardEvents(const EpisodeTable& table);

// CRC-32C (Castagnoli), as in RFC 3720: of the nine bytes "123456789" it is 0xE3069283.
uint32_t Crc32c(std::string_view bytes);

}  // namespace runtime
