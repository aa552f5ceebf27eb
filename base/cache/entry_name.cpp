#include "base/cache/entry_name.h"

#include <algorithm>

namespace cache {
namespace {

constexpr std::string_view kPluginEnding = ".so";
constexpr std::string_view kRefusal = "refused-";
constexpr std::string_view kDifference = "differs-";
constexpr std::string_view kNet = "net";
constexpr std::string_view kUnfinished = "building-";
constexpr size_t kKeyDigits = 32;
constexpr size_t kRandomCharacters = 6;

bool IsLetterOrDigit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool IsKeyDigit(char c) { return (c >= 'a' && c <= 'f') || (c >= '0' && c <= '9'); }

// "crawling-0123...": a task, or the word `net`, and a key.
bool IsWordWithKey(std::string_view text) {
  if (text.size() < kKeyDigits + 2) return false;
  const std::string_view word = text.substr(0, text.size() - kKeyDigits - 1);
  return text[word.size()] == '-' &&
         std::ranges::all_of(text.substr(word.size() + 1), IsKeyDigit) &&
         std::ranges::all_of(word, [](char c) { return IsLetterOrDigit(c) || c == '_'; });
}

bool Remove(std::string_view prefix, std::string_view& text) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

std::string WordWithKey(std::string_view word, std::string_view key) {
  return std::string(word) + "-" + std::string(key);
}

}  // namespace

EntryKind KindOf(std::string_view name) {
  if (name.ends_with(kPluginEnding)) {
    name.remove_suffix(kPluginEnding.size());
    return IsWordWithKey(name) ? EntryKind::kFile : EntryKind::kForeign;
  }
  if (Remove(kRefusal, name) || Remove(kDifference, name)) {
    return IsWordWithKey(name) ? EntryKind::kEvidence : EntryKind::kForeign;
  }
  if (Remove(kUnfinished, name)) {
    if (name.size() <= kRandomCharacters + 1) return EntryKind::kForeign;
    const size_t end = name.size() - kRandomCharacters;
    const bool is_ours = name[end - 1] == '-' && IsWordWithKey(name.substr(0, end - 1)) &&
                         std::ranges::all_of(name.substr(end), IsLetterOrDigit);
    return is_ours ? EntryKind::kUnfinished : EntryKind::kForeign;
  }
  const bool is_net = name.size() == kNet.size() + 1 + kKeyDigits && name.starts_with(kNet);
  return is_net && IsWordWithKey(name) ? EntryKind::kFile : EntryKind::kForeign;
}

std::string PluginName(std::string_view task, std::string_view key) {
  return WordWithKey(task, key).append(kPluginEnding);
}

std::string RefusalName(std::string_view task, std::string_view key) {
  return std::string(kRefusal) + WordWithKey(task, key);
}

std::string DifferenceName(std::string_view task, std::string_view key) {
  return std::string(kDifference) + WordWithKey(task, key);
}

std::string NetName(std::string_view key) { return WordWithKey(kNet, key); }

std::string UnfinishedName(std::string_view what, std::string_view key) {
  return std::string(kUnfinished) + WordWithKey(what, key) + "-" +
         std::string(kRandomCharacters, 'X');
}

}  // namespace cache
