#include "runtime/training/run/sealed_state.h"

#include <fmt/format.h>

#include <string_view>

#include "base/seal/sha256.h"

namespace runtime {
namespace {

constexpr std::string_view kMark = "sha-256 ";
constexpr size_t kSealSize = kMark.size() + 64;               // hexadecimal digits
constexpr std::string_view kCompressed = "\x28\xb5\x2f\xfd";  // how every state begins (zstd)

std::string SealOf(int64_t episode, std::string_view state) {
  return fmt::format("{}{}", kMark, seal::Sha256(fmt::format("{} {}", episode, state)));
}

}  // namespace

std::string SealState(int64_t episode, const std::string& state) {
  return SealOf(episode, state) + state;
}

std::optional<std::string> UnsealState(int64_t episode, std::string sealed) {
  if (sealed.starts_with(kCompressed)) return sealed;
  if (sealed.size() < kSealSize) return std::nullopt;
  const std::string state = sealed.substr(kSealSize);
  if (!sealed.starts_with(SealOf(episode, state))) return std::nullopt;
  return state;
}

}  // namespace runtime
