// One slip, one message: a single wrong word in a sound task has few consequences.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>

#include "compiler/analyze/analyze.h"
#include "compiler/syntax/lexed_tokens.h"
#include "tests/golden.h"

namespace compiler {
namespace {

// Errors of a text that is called like the file.
auto CountErrors(const std::filesystem::path& file, const std::string& text) {
  const FileReader read = [&](const std::filesystem::path& path) {
    return path == file ? std::optional(text) : ReadFromDisk(path);
  };
  const Analysis analysis = Analyze(file, read, SOURCE_DIR "/plugins");
  return std::ranges::count(analysis.diagnostics.list(), Severity::kError, &Diagnostic::severity);
}

std::string WithSlip(const std::string& text, Span word, std::mt19937& random) {
  static constexpr std::array<std::string_view, 8> kJunk = {"$",   ")", "}", "=",
                                                            "foo", "3", "(", "{"};
  const std::string_view junk = kJunk[random() % kJunk.size()];
  std::string slip = text;
  switch (random() % 4) {
    case 0:
      return slip.erase(word.begin, word.end - word.begin);
    case 1:
      return slip.insert(word.end, " " + text.substr(word.begin, word.end - word.begin));
    case 2:
      return slip.replace(word.begin, word.end - word.begin, junk);
    default:
      return slip.insert(word.begin, std::string(junk) + " ");
  }
}

TEST(Slips, HaveOneMessage) {
  std::mt19937 random(20126);
  int wrong = 0;
  int with_several = 0;
  for (const auto& file : golden::FilesIn(SOURCE_DIR "/tasks", "", ".task")) {
    const std::string text = golden::ReadFile(file);
    for (const LexedToken& token : Lex(text)) {
      if (random() % 4 != 0) continue;
      const auto errors = CountErrors(file, WithSlip(text, token.span, random));
      if (errors > 0) ++wrong;
      if (errors > 1) ++with_several;
    }
  }
  EXPECT_GT(wrong, 300);
  EXPECT_LT(with_several, wrong / 12) << "of " << wrong;
}

}  // namespace
}  // namespace compiler
