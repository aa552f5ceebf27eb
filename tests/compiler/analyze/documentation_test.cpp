// docs/diagnostics.md keeps its word on what comes from bounds and allowances: the first example of
// each section provokes the diagnostic, the second provokes nothing.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "compiler/analyze/analyze.h"
#include "tests/compiler/check/analysis_codes.h"
#include "tests/golden.h"

namespace compiler {
namespace {

std::vector<std::string> ExamplesOf(const std::string& page, std::string_view code) {
  const std::string begin = "```task\n";
  std::vector<std::string> examples;
  const size_t section = page.find("\n### " + std::string(code));
  if (section == std::string::npos) return examples;
  const size_t end = page.find("\n##", section + 1);
  for (size_t i = page.find(begin, section); i < end; i = page.find(begin, i)) {
    i += begin.size();
    examples.push_back(page.substr(i, page.find("```", i) - i));
  }
  return examples;
}

std::vector<std::string> CodesOf(const std::string& example) {
  const auto read = [&](const std::filesystem::path&) { return example; };
  const Analysis analysis = Analyze("example.task", read, SOURCE_DIR "/plugins");
  EXPECT_NE(analysis.task.has_value(), analysis.diagnostics.has_errors()) << example;
  std::vector<std::string> codes;
  for (const Diagnostic& diagnostic : analysis.diagnostics.list()) codes.push_back(diagnostic.code);
  return codes;
}

TEST(DiagnosticsPage, ExamplesProvokeWhatTheyExplain) {
  const std::string page = golden::ReadFile(SOURCE_DIR "/docs/diagnostics.md");
  for (const DiagnosticKind& kind : kDiagnosticTable) {
    if (!IsOfAnalysis(kind.code)) continue;
    const auto examples = ExamplesOf(page, kind.code);
    ASSERT_EQ(examples.size(), 2u) << kind.code;
    EXPECT_THAT(CodesOf(examples[0]), testing::ElementsAre(std::string(kind.code))) << examples[0];
    EXPECT_THAT(CodesOf(examples[1]), testing::IsEmpty()) << examples[1];
  }
}

}  // namespace
}  // namespace compiler
