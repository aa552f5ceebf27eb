#include "runtime/run/compression.h"

#include <fmt/format.h>
#include <zstd.h>

#include "runtime/module/user_error.h"

namespace runtime {
namespace {

constexpr int kLevel = 3;
// No blob of a run is larger; a damaged header must not make us ask for all memory there is.
constexpr unsigned long long kMaximumSize = 1ull << 31;

}  // namespace

std::string Compress(std::span<const std::byte> bytes) {
  std::string compressed(ZSTD_compressBound(bytes.size()), '\0');
  const size_t size =
      ZSTD_compress(compressed.data(), compressed.size(), bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size) != 0) {
    throw UserError(fmt::format("cannot compress: {}", ZSTD_getErrorName(size)));
  }
  compressed.resize(size);
  return compressed;
}

std::string Decompress(std::string_view compressed, std::string_view what) {
  const unsigned long long size = ZSTD_getFrameContentSize(compressed.data(), compressed.size());
  if (size > kMaximumSize) {  // so are the codes for a damaged header
    throw UserError(fmt::format("{} is damaged: it is no zstd data", what));
  }
  std::string bytes(size, '\0');
  const size_t got =
      ZSTD_decompress(bytes.data(), bytes.size(), compressed.data(), compressed.size());
  if (ZSTD_isError(got) != 0) {
    throw UserError(fmt::format("{} is damaged: {}", what, ZSTD_getErrorName(got)));
  }
  bytes.resize(got);
  return bytes;
}

}  // namespace runtime
