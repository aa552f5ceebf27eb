// Whatever stands in a file, the parser answers: with all of its tree, or with errors that a person
// can use.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/parse.h"
#include "tests/golden.h"

namespace compiler {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> Seeds() {
  std::vector<std::string> seeds;
  for (const auto& path : golden::FilesIn(SOURCE_DIR "/tasks", "", ".task")) {
    seeds.push_back(golden::ReadFile(path));
  }
  seeds.push_back(golden::ReadFile(SOURCE_DIR "/tests/compiler/syntax/every_construct.task"));
  const std::filesystem::path messages = SOURCE_DIR "/tests/compiler/syntax/messages";
  for (const auto& path : golden::FilesIn(messages, "fail_", ".task")) {
    seeds.push_back(golden::ReadInput(path));
  }
  return seeds;
}

// The generator's own output, so that every machine tests the same texts.
class Mutator {
 public:
  Mutator(std::vector<std::string> seeds, uint32_t seed)
      : seeds_(std::move(seeds)), random_(seed) {}

  std::string Next() {
    std::string text = seeds_[Below(seeds_.size())];
    for (size_t i = 0, count = 1 + Below(3); i < count; ++i) Mutate(text);
    return text;
  }

 private:
  size_t Below(size_t end) { return random_() % end; }

  void Mutate(std::string& text) {
    static const std::vector<std::string> kPieces = {"{",
                                                     "}",
                                                     "(",
                                                     ")",
                                                     "[",
                                                     "]",
                                                     "\"",
                                                     "'",
                                                     "//",
                                                     "///",
                                                     "/*",
                                                     "\n",
                                                     "\r",
                                                     "..",
                                                     ".",
                                                     "=",
                                                     "-",
                                                     "*",
                                                     "^",
                                                     ";",
                                                     "&&",
                                                     " reward ",
                                                     " on ",
                                                     " if ",
                                                     " else ",
                                                     " let ",
                                                     " task ",
                                                     " min ",
                                                     " m ",
                                                     " 5 ",
                                                     " 1e",
                                                     " .5 ",
                                                     " not ",
                                                     "\xff",
                                                     "\xe2\x88\x92",
                                                     std::string(1, '\0'),
                                                     "\xf0\x9f\x98\x80",
                                                     " end_episode ",
                                                     " in ",
                                                     " for ",
                                                     " for l in {",
                                                     " once per action if ",
                                                     " log ",
                                                     " require ",
                                                     "\nfn f(x: real) -> real {",
                                                     " return ",
                                                     "->",
                                                     "\nimport \"a.task\"\n",
                                                     " extends ",
                                                     "\noverride ",
                                                     "\ntest \"a\" {",
                                                     " given ",
                                                     " fire ",
                                                     " expect ",
                                                     "\nallow W0706\n",
                                                     " per ",
                                                     ",",
                                                     ":",
                                                     "<",
                                                     "x"};
    const size_t place = Below(text.size() + 1);
    const size_t length = std::min(text.size() - place, Below(12));
    switch (Below(5)) {
      case 0:
        text.erase(place, length);
        break;
      case 1:
        text.insert(place, text.substr(place, length));
        break;
      case 2:
        text.insert(place, kPieces[Below(kPieces.size())]);
        break;
      case 3:
        text.replace(place, length, kPieces[Below(kPieces.size())]);
        break;
      default:
        if (Below(8) == 0) text.erase(place);
        break;
    }
  }

  std::vector<std::string> seeds_;
  std::mt19937 random_;
};

void ExpectUsable(const SourceFile& source, const Diagnostic& diagnostic) {
  EXPECT_LE(diagnostic.span.begin, diagnostic.span.end);
  EXPECT_LE(diagnostic.span.end, source.text().size());
  EXPECT_FALSE(diagnostic.message.empty());
  EXPECT_THAT(diagnostic.message,
              Not(AnyOf(HasSubstr("mismatched"), HasSubstr("viable"), HasSubstr("extraneous"),
                        HasSubstr("LINE_END"), HasSubstr("``"))))
      << source.text();
  for (const Label& label : diagnostic.labels) EXPECT_LE(label.span.end, source.text().size());
}

TEST(Mutations, AreParsedOrExplained) {
  constexpr int kTexts = 600;
  Mutator mutator(Seeds(), 20121);
  for (int i = 0; i < kTexts; ++i) {
    const Sources sources("mutated.task", mutator.Next());
    const SourceFile& source = sources.main();
    Diagnostics diagnostics;
    const auto tree = Parse(source, diagnostics);
    const bool is_whole = tree && tree->lost.is_empty();
    EXPECT_TRUE(is_whole || diagnostics.has_errors()) << source.text();
    for (const Diagnostic& diagnostic : diagnostics.list()) ExpectUsable(source, diagnostic);
    EXPECT_NE(Render(sources, diagnostics, false).empty(), diagnostics.has_errors());
  }
}

}  // namespace
}  // namespace compiler
