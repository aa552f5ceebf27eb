#include "compiler/source/diagnostic.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace compiler {
namespace {

TEST(Diagnostics, AreListedInTheOrderOfTheirPlaces) {
  Diagnostics diagnostics;
  diagnostics.Add(MakeDiagnostic(code::kUnexpectedToken, {9, 10}, "third"));
  diagnostics.Add(MakeDiagnostic(code::kUnexpectedToken, {2, 3}, "first"));
  diagnostics.Add(MakeDiagnostic(code::kUnexpectedToken, {2, 8}, "second"));
  ASSERT_EQ(diagnostics.list().size(), 3u);
  EXPECT_EQ(diagnostics.list()[0].message, "first");
  EXPECT_EQ(diagnostics.list()[1].message, "second");
  EXPECT_EQ(diagnostics.list()[2].message, "third");
}

TEST(Diagnostics, SayNothingTwice) {
  Diagnostics diagnostics;
  for (int i = 0; i < 2; ++i) {
    diagnostics.Add(MakeDiagnostic(code::kUnexpectedToken, {2, 3}, "one"));
    diagnostics.Add(MakeDiagnostic(code::kUnexpectedToken, {2, 3}, "another"));
    diagnostics.Add(MakeDiagnostic(code::kBrokenLine, {2, 3}, "one"));
    diagnostics.Add(MakeDiagnostic(code::kUnexpectedToken, {2, 4}, "one"));
    diagnostics.Add(MakeDiagnostic(code::kUnexpectedToken, {1, 3}, "one"));
  }
  EXPECT_EQ(diagnostics.list().size(), 5u);
}

TEST(Diagnostics, AWarningIsNoError) {
  Diagnostics diagnostics;
  Diagnostic warning = MakeDiagnostic(code::kUnexpectedToken, {}, "a warning");
  warning.severity = Severity::kWarning;
  diagnostics.Add(warning);
  EXPECT_FALSE(diagnostics.has_errors());
  diagnostics.Add(MakeDiagnostic(code::kUnexpectedToken, {}, "an error"));
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(DiagnosticTable, CodesAreUniqueAndSayTheirSeverity) {
  std::set<std::string_view> codes;
  for (const DiagnosticKind& kind : kDiagnosticTable) {
    EXPECT_TRUE(codes.insert(kind.code).second) << kind.code << " is there twice";
    ASSERT_EQ(kind.code.size(), 5u) << kind.code;
    EXPECT_TRUE(kind.code.front() == 'E' || kind.code.front() == 'W') << kind.code;
    EXPECT_EQ(MakeDiagnostic(kind.code, {}, "").severity,
              kind.code.front() == 'W' ? Severity::kWarning : Severity::kError);
    EXPECT_FALSE(kind.title.empty());
    EXPECT_NE(kind.title.back(), '.') << kind.title;
  }
}

}  // namespace
}  // namespace compiler
