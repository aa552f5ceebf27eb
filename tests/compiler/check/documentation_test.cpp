// docs/diagnostics.md keeps its word: the first example of each section provokes the diagnostic,
// the second does not.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <string>
#include <utility>
#include <vector>

#include "compiler/source/diagnostic_table.h"
#include "plugins/robot/sensors.h"
#include "tests/compiler/check/analysis_codes.h"
#include "tests/compiler/check/checked_source.h"
#include "tests/golden.h"

namespace compiler {
namespace {

const std::string kBegin = "```task\n";
const std::string kFence = "```";

std::vector<std::string> ExamplesOf(const std::string& text) {
  std::vector<std::string> examples;
  for (size_t i = text.find(kBegin); i != std::string::npos; i = text.find(kBegin, i)) {
    i += kBegin.size();
    examples.push_back(text.substr(i, text.find(kFence, i) - i));
  }
  return examples;
}

// The part of the page that explains one code.
std::string SectionOf(const std::string& page, std::string_view code) {
  const size_t section = page.find("\n### " + std::string(code));
  EXPECT_NE(section, std::string::npos) << code;
  return section == std::string::npos
             ? ""
             : page.substr(section, page.find("\n##", section + 1) - section);
}

bool HasLineWith(const std::string& text, const std::string& begin) {
  return text.starts_with(begin) || text.find("\n" + begin) != std::string::npos;
}

// An example is a whole task, or declarations, or statements.
std::string AsTask(const std::string& example) {
  if (HasLineWith(example, "task ")) return example;
  if (HasLineWith(example, "sensor ")) return "task example\n" + example;
  for (const char* word :
       {"start ", "after_end ", "param ", "const ", "set ", "table ", "memory ", "goal ",
        "observe ", "phase ", "metric ", "reward potential ", "fn ", "test ", "on "})
    if (HasLineWith(example, word)) return "task example for humanoid\n" + example;
  return TaskText("", example);
}

std::vector<std::string> CodesOfExample(const std::string& example) {
  const CheckedSource checked(AsTask(example));
  EXPECT_TRUE(checked.is_parsed) << checked.Messages();
  std::vector<std::string> codes;
  for (const Diagnostic& diagnostic : checked.diagnostics.list()) codes.push_back(diagnostic.code);
  return codes;
}

TEST(DiagnosticsPage, ExamplesProvokeWhatTheyExplain) {
  const std::string page = golden::ReadFile(SOURCE_DIR "/docs/diagnostics.md");
  for (const DiagnosticKind& kind : kDiagnosticTable) {
    if (kind.code.starts_with("E01") || kind.code == code::kUnknownRobot) continue;
    if (IsOfAnalysis(kind.code)) continue;  // see tests/compiler/analyze
    const auto examples = ExamplesOf(SectionOf(page, kind.code));
    if (examples.empty()) continue;  // too long to print
    ASSERT_EQ(examples.size(), 2u) << kind.code;
    const std::string code(kind.code);
    EXPECT_THAT(CodesOfExample(examples[0]), testing::Contains(code)) << examples[0];
    const auto better = CodesOfExample(examples[1]);
    EXPECT_THAT(better, testing::Not(testing::Contains(code))) << examples[1];
    EXPECT_THAT(better, testing::Each(testing::StartsWith("W"))) << examples[1];
  }
}

TEST(Documentation, NamesEverySensor) {
  const std::string page = golden::ReadFile(SOURCE_DIR "/docs/language.md");
  const std::string section = page.substr(page.find("\n## Sensors\n"));
  for (const robot::SensorDescription& sensor : robot::Sensors())
    EXPECT_THAT(section, testing::HasSubstr(fmt::format("`{}`", sensor.name)));
}

TEST(Documentation, ExamplesAreFreeOfErrors) {
  // The tutorial's are parts of a file that grows: see tests/compiler/driver/tutorial_test.cpp.
  const std::pair<const char*, size_t> pages[] = {{"/docs/language.md", 20},
                                                  {"/docs/from-skyai.md", 1}};
  for (const auto& [page, least] : pages) {
    const auto examples = ExamplesOf(golden::ReadFile(std::string(SOURCE_DIR) + page));
    EXPECT_GE(examples.size(), least) << page;
    for (const std::string& example : examples)
      EXPECT_THAT(CodesOfExample(example), testing::Each(testing::StartsWith("W"))) << example;
  }
}

}  // namespace
}  // namespace compiler
