#include "compiler/check/report.h"

#include <algorithm>
#include <set>
#include <utility>

namespace compiler {
namespace {

constexpr size_t kLongestList = 40;

std::set<std::string_view> WordsOf(std::string_view name) {
  std::set<std::string_view> words;
  while (!name.empty()) {
    const size_t end = std::min(name.find_first_of("_."), name.size());
    words.insert(name.substr(0, end));
    name.remove_prefix(std::min(end + 1, name.size()));
  }
  return words;
}

// The valid names that hold all words of `name`, as `left_knee_pitch` holds those of `left_knee`.
std::vector<std::string> WithTheWordsOf(std::string_view name,
                                        const std::vector<std::string>& valid) {
  constexpr size_t kShortest = 3;
  std::vector<std::string> found;
  const auto words = WordsOf(name);
  for (const std::string& candidate : valid)
    if (name.size() >= kShortest && std::ranges::includes(WordsOf(candidate), words))
      found.push_back(candidate);
  return found;
}

}  // namespace

void Report(Diagnostics& diagnostics, std::string_view code, Span span, std::string message,
            Explanation explanation) {
  Diagnostic diagnostic = MakeDiagnostic(code, span, std::move(message));
  diagnostic.note = std::move(explanation.note);
  diagnostic.help = std::move(explanation.help);
  diagnostic.labels = std::move(explanation.labels);
  diagnostics.Add(std::move(diagnostic));
}

std::string List(const std::vector<std::string>& names) {
  std::string text;
  for (size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += fmt::format("`{}`", names[i]);
  }
  return text;
}

Help Suggest(Span span, std::string_view name, const std::vector<std::string>& valid,
             std::string_view what) {
  const auto nearest = text::NearestName(name, valid);
  const bool is_slip = nearest && text::SpellingDistance(name, *nearest) < 2;
  const std::vector<std::string> longer = WithTheWordsOf(name, valid);
  constexpr size_t kMostNamed = 4;
  if (!is_slip && longer.size() == 1) return DidYouMean(span, longer.front());
  if (!is_slip && longer.size() > 1 && longer.size() <= kMostNamed) {
    Help help = fmt::format("there are {}", List(longer));
    for (const std::string& candidate : longer) help.fixes.push_back({span, candidate});
    return help;
  }
  if (nearest) return DidYouMean(span, *nearest);
  if (valid.empty() || valid.size() > kLongestList) return "";
  return fmt::format("the {} are {}", what, List(valid));
}

}  // namespace compiler
