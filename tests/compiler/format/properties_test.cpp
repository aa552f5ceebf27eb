// What must hold for every task: formatting it twice changes nothing more, and the task stays the
// same.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "compiler/format/format.h"
#include "compiler/syntax/parse.h"
#include "compiler/syntax/written_tokens.h"
#include "tests/compiler/syntax/syntax_text.h"
#include "tests/golden.h"

namespace compiler {
namespace {

std::vector<std::string> Blocks(const std::string& page) {
  constexpr std::string_view kBegin = "```task\n";
  std::vector<std::string> blocks;
  for (size_t i = page.find(kBegin); i != std::string::npos; i = page.find(kBegin, i)) {
    i += kBegin.size();
    blocks.push_back(page.substr(i, page.find("```", i) - i));
  }
  return blocks;
}

// Tasks of all kinds, the documentation's examples among them. Those that are statements only are
// put into a task.
const std::vector<std::string>& Tasks() {
  static const std::vector<std::string> tasks = [] {
    std::vector<std::string> found;
    for (const auto& file : golden::FilesIn(SOURCE_DIR "/tasks", "", ".task")) {
      found.push_back(golden::ReadFile(file));
    }
    for (const char* folder : {"/tests/compiler/emit/golden", "/tests/compiler/check/messages"}) {
      for (const auto& file : golden::FilesIn(std::string(SOURCE_DIR) + folder, "", ".task")) {
        found.push_back(golden::ReadInput(file));
      }
    }
    for (const char* page : {"/docs/language.md", "/docs/diagnostics.md"}) {
      for (const std::string& block : Blocks(golden::ReadFile(std::string(SOURCE_DIR) + page))) {
        found.push_back(block);
        found.push_back("task t\n" + block);
        found.push_back("task t\non end_of_time_step {\n" + block + "}\n");
      }
    }
    return found;
  }();
  return tasks;
}

std::optional<std::string> FormatText(const std::string& text) {
  Diagnostics diagnostics;
  return Format(SourceFile("a.task", text), diagnostics);
}

// The tokens one by one, and the comments between them without the blanks around them.
std::string Essence(const std::string& text) {
  const SourceFile source("a.task", text);
  Diagnostics diagnostics;
  std::string essence;
  uint32_t end = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  auto add_gap = [&](uint32_t begin) {
    for (size_t i = text.find('/', end); i < begin;) {
      const size_t comment_end = std::min(text.find_first_of("\r\n", i), text.size());
      const std::string comment = text.substr(i, comment_end - i);
      essence += comment.substr(0, comment.find_last_not_of(" \t\f") + 1) + '\n';
      i = text.find('/', comment_end);
    }
  };
  const auto tokens = ReadTokens(source, diagnostics);
  for (const WrittenToken& token : tokens.value()) {
    add_gap(token.span.begin);
    essence += text.substr(token.span.begin, token.span.end - token.span.begin) + '\n';
    end = token.span.end;
  }
  add_gap(static_cast<uint32_t>(text.size()));
  return essence;
}

// What the parser understands: the documentation comments, and the blocks of events.
std::vector<std::string> MeaningOf(const std::string& text) {
  Diagnostics diagnostics;
  const auto tree = Parse(SourceFile("a.task", text), diagnostics);
  std::vector<std::string> meaning{tree->doc};
  for (const Declaration& declaration : tree->declarations) {
    std::visit(
        [&](const auto& node) {
          if constexpr (requires { node.doc; }) meaning.push_back(node.doc);
        },
        declaration.node);
    const auto* event = std::get_if<EventDeclaration>(&declaration.node);
    if (event != nullptr) meaning.push_back(ToText(event->body));
  }
  return meaning;
}

void ExpectSound(const std::string& text) {
  const auto once = FormatText(text);
  if (!once) return;
  EXPECT_EQ(FormatText(*once), once) << "of " << text;
  EXPECT_EQ(Essence(*once), Essence(text));
  EXPECT_EQ(MeaningOf(*once), MeaningOf(text)) << text;
}

TEST(FormatProperties, HoldForAllTasks) {
  size_t count = 0;
  for (const std::string& text : Tasks()) {
    if (FormatText(text)) ++count;
    ExpectSound(text);
  }
  EXPECT_GT(count, 100u);
}

TEST(FormatProperties, ShippedTasksAreLaidOut) {
  for (const auto& file : golden::FilesIn(SOURCE_DIR "/tasks", "", ".task")) {
    const std::string text = golden::ReadFile(file);
    EXPECT_EQ(FormatText(text), text) << file;
  }
}

// Blanks of all kinds put between the tokens, comments among them.
class Scrambler {
 public:
  explicit Scrambler(uint32_t seed) : random_(seed) {}

  std::string Scramble(const std::string& text, const std::vector<WrittenToken>& tokens) {
    std::string result;
    uint32_t end = 0;
    for (const WrittenToken& token : tokens) {
      result += Blank(text.substr(end, token.span.begin - end));
      result += text.substr(token.span.begin, token.span.end - token.span.begin);
      end = token.span.end;
    }
    return result + Blank(text.substr(end));
  }

 private:
  std::string Blank(const std::string& written) {
    static const std::vector<std::string> kBlanks = {"",
                                                     " ",
                                                     "   ",
                                                     "\t",
                                                     "\n",
                                                     "\n\n\n",
                                                     "\n  ",
                                                     "\r\n",
                                                     "\f",
                                                     " // note\n",
                                                     "\n// note \n",
                                                     "\n/// doc\n",
                                                     " /// no doc\n",
                                                     "// a\n\n// b\n"};
    return random_() % 4 != 0 ? written : kBlanks[random_() % kBlanks.size()];
  }

  std::mt19937 random_;
};

TEST(FormatProperties, HoldForAllLayouts) {
  Scrambler scrambler(7);
  int parsed = 0;
  for (const std::string& text : Tasks()) {
    Diagnostics diagnostics;
    const auto tokens = ReadTokens(SourceFile("a.task", text), diagnostics);
    if (!tokens) continue;
    for (int i = 0; i < 10; ++i) {
      const std::string scrambled = scrambler.Scramble(text, *tokens);
      if (FormatText(scrambled)) ++parsed;
      ExpectSound(scrambled);
    }
  }
  EXPECT_GT(parsed, 100);
}

// A text with some of its bytes changed: formatted if it is still a task, else left alone.
TEST(FormatProperties, HoldForDamagedTexts) {
  constexpr int kTexts = 2000;
  static const std::string kBytes = "{}()[]\"/ \n\r\t.=-+*^:,a1\xC3\xA4";
  std::mt19937 random(11);
  int parsed = 0;
  for (int i = 0; i < kTexts; ++i) {
    std::string text = Tasks()[random() % Tasks().size()];
    text[random() % text.size()] = kBytes[random() % kBytes.size()];
    if (FormatText(text)) ++parsed;
    ExpectSound(text);
  }
  EXPECT_GT(parsed, 50);
}

}  // namespace
}  // namespace compiler
