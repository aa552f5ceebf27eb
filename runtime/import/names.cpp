#include "runtime/import/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

#include "plugins/robot/reserved_words.h"

namespace runtime {
namespace {

bool IsLetterOrDigit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

std::string Written(std::string_view wanted) {
  std::string name;
  for (const char c : wanted) name += IsLetterOrDigit(c) ? c : '_';
  if (!name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) != 0)
    name.insert(0, "_");
  return name;
}

// "FL_knee_joint": words of letters of one case or of digits, and what is between them.
std::vector<std::string> WordsOf(const std::string& name) {
  const auto kind = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isupper(byte) ? 1 : std::islower(byte) ? 2 : std::isdigit(byte) ? 3 : 4;
  };
  std::vector<std::string> words;
  for (const char c : name) {
    const bool goes_on =
        !words.empty() &&
        (kind(words.back().back()) == kind(c) ||
         // "Left"
         (words.back().size() == 1 && kind(words.back().front()) == 1 && kind(c) == 2));
    if (!goes_on) words.emplace_back();
    words.back() += c;
  }
  return words;
}

}  // namespace

std::string Names::Take(std::string_view wanted, std::string_view fallback) {
  std::string name = Written(wanted);
  if (name.empty()) name = fallback;
  if (robot::IsReservedWord(name)) name += "_";
  if (!wanted.empty() && name != wanted)
    renamed_.push_back(fmt::format("`{}` as `{}`", wanted, name));
  std::string free = name;
  for (int i = 2; !taken_.insert(free).second; ++i) free = fmt::format("{}_{}", name, i);
  return free;
}

std::string OnTheRight(const std::string& name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 19> kSides = {{
      {"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}, {"l", "r"},   {"L", "R"},
      {"FL", "FR"},      {"ML", "MR"},      {"RL", "RR"},      {"HL", "HR"}, {"BL", "BR"},
      {"LF", "RF"},      {"LH", "RH"},      {"fl", "fr"},      {"ml", "mr"}, {"rl", "rr"},
      {"hl", "hr"},      {"bl", "br"},      {"lf", "rf"},      {"lh", "rh"},
  }};
  std::string right;
  bool has_side = false;
  for (const std::string& word : WordsOf(name)) {
    const auto side = std::ranges::find(kSides, word, [](const auto& each) { return each.first; });
    const bool is_left = !has_side && side != kSides.end();
    right += is_left ? std::string(side->second) : word;
    has_side = has_side || is_left;
  }
  return has_side ? right : "";
}

}  // namespace runtime
