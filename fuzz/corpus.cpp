#include "fuzz/corpus.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "compiler/check/builtins.h"
#include "compiler/check/type.h"
#include "compiler/check/unit.h"
#include "compiler/syntax/words.h"
#include "tests/golden_file.h"

namespace fuzz {
namespace {

namespace fs = std::filesystem;

std::string ReadFile(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// What stands between quotes in the grammar: 'reward', '<='.
void AddWordsOfGrammar(std::vector<std::string>& words) {
  const std::string grammar = ReadFile(SOURCE_DIR "/grammar/Task.g4");
  static const std::regex kQuoted("'([^'\\\\\n]+)'");
  for (std::sregex_iterator match(grammar.begin(), grammar.end(), kQuoted), end; match != end;
       ++match) {
    words.push_back((*match)[1]);
  }
}

void AddAll(const std::vector<std::string>& some, std::vector<std::string>& words) {
  words.insert(words.end(), some.begin(), some.end());
}

template <typename Table>
void AddTable(const Table& table, std::vector<std::string>& words) {
  for (const auto& word : table) words.emplace_back(word.text);
}

}  // namespace

std::vector<std::string> TextsIn(const std::vector<const char*>& folders, const char* ending) {
  std::vector<fs::path> files;
  for (const char* folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(SOURCE_DIR + std::string(folder))) {
      if (entry.path().string().ends_with(ending)) files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  std::vector<std::string> texts;
  for (const fs::path& file : files) texts.push_back(golden::Split(file, ReadFile(file)).input);
  return texts;
}

std::vector<std::string> TaskTexts() {
  return TextsIn({"/tasks", "/tests/compiler", "/tests/runtime/trainer/tasks"}, ".task");
}

std::vector<std::string> TableTexts() { return TextsIn({"/tests/compiler/check/tables"}, ".csv"); }

std::vector<std::string> TaskWords() {
  std::vector<std::string> words;
  AddWordsOfGrammar(words);
  AddAll(compiler::BuiltinNames(), words);
  AddAll(compiler::TypeNames(), words);
  AddAll(compiler::KnownUnits(), words);
  AddTable(compiler::kEventNames, words);
  AddTable(compiler::kRewardKindNames, words);
  AddTable(compiler::kReductionNames, words);
  AddTable(compiler::kScopeNames, words);
  AddTable(compiler::kOutcomeNames, words);
  AddAll({"humanoid",
          "base.position",
          "base.velocity.xy",
          "base.rotation",
          "contact",
          "joint.angle",
          "links",
          "site.position",
          "sites",
          "toes",
          "feet",
          "head",
          "time_step",
          "reward",
          "onboard",
          "x",
          "0",
          "1",
          "2..7",
          "0.5",
          "1e308",
          "1e-400",
          "9007199254740993",
          "99999999999999999999",
          "4 / s",
          "\"why\"",
          "\\",
          "\n",
          "\r",
          "\t",
          "//",
          "///",
          "/*",
          ";",
          "&&",
          "'",
          "\xff",
          "\xe2\x88\x92",
          std::string(1, '\0'),
          "\xf0\x9f\x98\x80"},
         words);
  return words;
}

std::vector<std::string> TableWords() {
  std::vector<std::string> words = {",",
                                    ";",
                                    "\t",
                                    " ",
                                    "\n",
                                    "\r\n",
                                    "\"",
                                    "\xEF\xBB\xBF",
                                    "[",
                                    "]",
                                    "[s]",
                                    "[m]",
                                    "[cm]",
                                    "[rad]",
                                    "[deg]",
                                    "[km^90]",
                                    "[]",
                                    "0",
                                    "-1",
                                    "0.5",
                                    "1e99",
                                    "1e101",
                                    "1e999",
                                    "1e-400",
                                    "nan",
                                    "inf",
                                    "+1",
                                    "1,5",
                                    "time",
                                    "x",
                                    "y",
                                    "z",
                                    "w",
                                    "0.x",
                                    "joint.angle",
                                    "\xff",
                                    "left_knee_pitch",
                                    "right_knee_pitch",
                                    std::string(1, '\0')};
  AddAll(compiler::KnownUnits(), words);
  return words;
}

}  // namespace fuzz
