#pragma once

#include <filesystem>
#include <string>

namespace runtime {

// The address of the page of the trainer that works in `folder`, for a browser; it has the token in
// it. Throws UserError where no trainer says how to reach it.
std::string PageAddress(const std::filesystem::path& folder);

}  // namespace runtime
