#include "base/seal/seal.h"

#include <utility>

#include "base/seal/sha256.h"

namespace seal {
namespace {

constexpr std::string_view kMark = "\ntaskc sha-256 ";
static_assert(kSize == kMark.size() + 64);  // hexadecimal digits

}  // namespace

std::string Seal(std::string plugin) {
  const std::string hash = Sha256(plugin);
  return std::move(plugin.append(kMark).append(hash));
}

State StateOf(std::string_view content) {
  if (content.size() < kSize) return State::kAbsent;
  const std::string_view plugin = content.substr(0, content.size() - kSize);
  const std::string_view seal = content.substr(plugin.size());
  if (!IsSeal(seal)) return State::kAbsent;
  return seal.substr(kMark.size()) == Sha256(plugin) ? State::kIntact : State::kBroken;
}

bool IsSeal(std::string_view end) { return end.size() == kSize && end.starts_with(kMark); }

}  // namespace seal
