// Looks a written word up in one of the tables of words.h.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/text/nearest_name.h"
#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/words.h"

namespace compiler {

// What the word means; if it is not in the table, reports it with the diagnostic `code` (`what`:
// what the table lists, in the singular) and returns the meaning of the nearest word, or else the
// table's first.
template <typename Meaning, size_t size>
Meaning LookUp(const Identifier& word, const std::array<Word<Meaning>, size>& words,
               std::string_view code, const std::string& what, SyntaxReport& report) {
  std::vector<std::string> names;
  for (const Word<Meaning>& candidate : words) {
    if (candidate.text == word.text) return candidate.meaning;
    names.emplace_back(candidate.text);
  }
  Diagnostic diagnostic =
      MakeDiagnostic(code, word.span, fmt::format("`{}` is not {}", word.text, what));
  Meaning meant = words.front().meaning;
  if (const auto nearest = text::NearestName(word.text, names)) {
    diagnostic.help = DidYouMean(word.span, *nearest);
    meant = words[static_cast<size_t>(std::ranges::find(names, *nearest) - names.begin())].meaning;
  } else {
    std::string& help = diagnostic.help.text = "it is one of ";
    for (size_t i = 0; i < names.size(); ++i) {
      if (i > 0) help += i + 1 < names.size() ? ", " : " and ";
      help += fmt::format("`{}`", names[i]);
    }
  }
  report.AddMended(std::move(diagnostic));
  return meant;
}

}  // namespace compiler
