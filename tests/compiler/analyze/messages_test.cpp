// The warnings that need a whole, checked task, word for word: behind each task of messages/ stands
// all that is said about it.
#include <gtest/gtest.h>

#include <set>

#include "compiler/analyze/analyze.h"
#include "tests/golden.h"

namespace compiler {
namespace {

const std::filesystem::path kFolder = SOURCE_DIR "/tests/compiler/analyze/messages";

// Under a path that does not depend on where the project lies.
Analysis AnalyzeFile(const std::filesystem::path& file) {
  const auto read = [&](const std::filesystem::path& name) {
    return golden::ReadInput(file.parent_path() / name);
  };
  return Analyze(file.filename(), read, SOURCE_DIR "/plugins");
}

TEST(WarningMessages, AreAsReviewed) {
  for (const auto& file : golden::FilesIn(kFolder, "warn_", ".task")) {
    const Analysis analysis = AnalyzeFile(file);
    EXPECT_TRUE(analysis.task) << file;
    golden::ExpectBehindInput(file, Render(analysis.sources, analysis.diagnostics, false));
  }
}

TEST(WarningMessages, ProvokeEveryWarningOfBoundsAndAllowances) {
  std::set<std::string, std::less<>> provoked;
  for (const auto& file : golden::FilesIn(kFolder, "warn_", ".task")) {
    const Analysis analysis = AnalyzeFile(file);
    for (const Diagnostic& diagnostic : analysis.diagnostics.list())
      provoked.insert(diagnostic.code);
  }
  for (const DiagnosticKind& kind : kDiagnosticTable)
    if (kind.code >= code::kUselessAllow && kind.code <= code::kCertainEnd) {
      EXPECT_TRUE(provoked.contains(kind.code)) << kind.code;
    }
}

TEST(WarningMessages, AreNotGivenForTheTasksOfThePaper) {
  for (const auto& file : golden::FilesIn(SOURCE_DIR "/tasks", "", ".task")) {
    const Analysis analysis = AnalyzeFile(file);
    EXPECT_EQ(Render(analysis.sources, analysis.diagnostics, false), "") << file;
  }
}

}  // namespace
}  // namespace compiler
