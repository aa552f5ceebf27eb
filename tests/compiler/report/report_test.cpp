#include "compiler/report/report.h"

#include <gtest/gtest.h>

#include "tests/golden.h"

namespace compiler {
namespace {

constexpr const char* kGolden = SOURCE_DIR "/tests/compiler/report/golden/";

// An error with everything that a diagnostic can have, and a warning with nothing.
RunReport SampleReport() {
  Sources sources("my tasks/bäd.task", "task bad\nmetric größe = höhe\n");
  Diagnostics diagnostics;
  Diagnostic error = MakeDiagnostic(code::kUnknownName, {26, 31}, "there is nothing called `höhe`");
  error.note = "not declared";
  error.help = DidYouMean({26, 31}, "pi");
  error.labels.push_back({{0, 4}, "in this \"task\""});
  diagnostics.Add(error);
  diagnostics.Add(MakeDiagnostic(code::kNeverEnds, {5, 8}, "the task never ends"));
  RunReport report;
  report.Add(sources, diagnostics);
  report.failures.push_back("cannot read `absent.task`");
  report.tasks.push_back({{"file", "my tasks/bäd.task"}, {"ok", false}});
  report.exit_status = 2;
  return report;
}

TEST(JsonReport, IsAsReviewed) {
  golden::Expect(std::string(kGolden) + "report.json.expected", ToText(ToJson(SampleReport())));
}

TEST(JsonReport, SurvivesBytesThatAreNoUtf8) {
  RunReport report;
  report.failures.push_back("cannot read `\xff`");
  EXPECT_NE(ToText(ToJson(report)).find("cannot read `\uFFFD`"), std::string::npos);
}

// The rules are left out: they are the table of diagnostics.
TEST(SarifReport, IsAsReviewed) {
  Json sarif = ToSarif(SampleReport());
  sarif["runs"][0]["tool"]["driver"].erase("rules");
  golden::Expect(std::string(kGolden) + "report.sarif.expected", ToText(sarif));
}

// What the schema of SARIF 2.1.0 demands and is not seen in the reviewed file.
TEST(SarifReport, ListsEachRuleOnce) {
  Json sarif = ToSarif(SampleReport());
  const Json& rules = sarif["runs"][0]["tool"]["driver"]["rules"];
  ASSERT_EQ(rules.size(), std::size(kDiagnosticTable));
  for (const Json& rule : rules) {
    EXPECT_TRUE(rule["id"].is_string());
    EXPECT_TRUE(rule["shortDescription"]["text"].is_string());
    EXPECT_TRUE(rule["help"]["text"].is_string());
  }
  for (const Json& result : sarif["runs"][0]["results"]) {
    EXPECT_EQ(rules[result["ruleIndex"].get<size_t>()]["id"], result["ruleId"]);
  }
}

TEST(SarifReport, OfAFineTaskHasEmptyResults) {
  Json sarif = ToSarif(RunReport());
  EXPECT_EQ(sarif["runs"][0]["results"], Json::array());
  EXPECT_EQ(sarif["runs"][0]["invocations"][0]["executionSuccessful"], true);
}

}  // namespace
}  // namespace compiler
