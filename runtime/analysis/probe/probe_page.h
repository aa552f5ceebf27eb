// The page of a probe: the motions that it has found, each with its pictures and replay.
#pragma once

#include <filesystem>

#include "runtime/analysis/probe/find.h"

namespace runtime {

// Writes it to `file`. Throws UserError.
void WriteProbePage(const ProbeResults& results, const std::filesystem::path& file);

}  // namespace runtime
