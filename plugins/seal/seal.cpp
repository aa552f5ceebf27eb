#include "plugins/seal/seal.h"

#include <utility>

#include "plugins/seal/sha256.h"

namespace seal {
namespace {

constexpr std::string_view kMark = "\ntaskc sha-256 ";
constexpr size_t kSealSize = kMark.size() + 64;  // hexadecimal digits

}  // namespace

std::string Seal(std::string plugin) {
  const std::string hash = Sha256(plugin);
  return std::move(plugin.append(kMark).append(hash));
}

State StateOf(std::string_view content) {
  if (content.size() < kSealSize) return State::kAbsent;
  const std::string_view plugin = content.substr(0, content.size() - kSealSize);
  const std::string_view seal = content.substr(plugin.size());
  if (!seal.starts_with(kMark)) return State::kAbsent;
  return seal.substr(kMark.size()) == Sha256(plugin) ? State::kIntact : State::kBroken;
}

}  // namespace seal
