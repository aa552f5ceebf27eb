#include "runtime/task/plugin_seal.h"

#include <sys/types.h>
//
#include <sha256.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace runtime {
namespace {

constexpr std::string_view kMark = "\ntaskc sha-256 ";
constexpr size_t kSealSize = kMark.size() + SHA256_DIGEST_STRING_LENGTH - 1;

}  // namespace

bool HasBrokenSeal(std::span<const std::byte> content) {
  if (content.size() < kSealSize) return false;
  const std::span<const std::byte> plugin = content.first(content.size() - kSealSize);
  const std::string_view seal(reinterpret_cast<const char*>(plugin.data() + plugin.size()),
                              kSealSize);
  if (!seal.starts_with(kMark)) return false;
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digits;
  SHA256_Data(reinterpret_cast<const uint8_t*>(plugin.data()), plugin.size(), digits.data());
  return seal.substr(kMark.size()) != std::string_view(digits.data());
}

}  // namespace runtime
