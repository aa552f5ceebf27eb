#include "compiler/syntax/foreign_words.h"

#include <algorithm>
#include <array>
#include <string>

namespace compiler {
namespace {

using enum ForeignPlace;

constexpr std::array kForeignWords = {
#define FOREIGN(place, word, instead, help) ForeignWord{place, word, instead, help},
#include "compiler/syntax/foreign_words.def"
#undef FOREIGN
};

}  // namespace

const ForeignWord* FindForeign(ForeignPlace place, std::string_view word) {
  const auto* found = std::ranges::find_if(kForeignWords, [&](const ForeignWord& foreign) {
    return foreign.place == place && foreign.text == word;
  });
  return found != kForeignWords.end() ? found : nullptr;
}

Help HelpForForeign(ForeignPlace place, std::string_view word, Span span) {
  const ForeignWord* found = FindForeign(place, word);
  if (found == nullptr) return {};
  const std::string instead(found->instead);
  Help help = found->help.empty() ? "write `" + instead + "`" : std::string(found->help);
  if (!instead.empty()) help.fixes = {{span, instead}};
  return help;
}

}  // namespace compiler
