// Blobs of the run database: zstd, with errors for the user.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace runtime {

// With a checksum of `bytes`.
std::string Compress(std::span<const std::byte> bytes);

// `what` names the blob in the UserError that is thrown where it is damaged.
std::string Decompress(std::string_view compressed, std::string_view what);

}  // namespace runtime
