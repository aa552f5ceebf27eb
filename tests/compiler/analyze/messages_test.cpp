// What needs a whole task, word for word: behind each task of messages/ stands all that is said
// about it. Those of warn_* need a checked task; fail_* are mistakes of several phases; both are of
// several files where they are texts as SplitFiles() reads them.
#include <gtest/gtest.h>

#include <set>

#include "compiler/analyze/analyze.h"
#include "tests/compiler/check/analysis_codes.h"
#include "tests/compiler/compose/file_set.h"
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

Analysis AnalyzeFiles(const std::filesystem::path& file) {
  return Analyze("main.task", ReaderOf(SplitFiles(golden::ReadInput(file))), SOURCE_DIR "/plugins");
}

TEST(ErrorMessages, AreAllGivenAtOnce) {
  for (const auto& file : golden::FilesIn(kFolder, "fail_", ".task")) {
    const Analysis analysis = AnalyzeFile(file);
    EXPECT_TRUE(analysis.diagnostics.has_errors()) << file;
    golden::ExpectBehindInput(file, Render(analysis.sources, analysis.diagnostics, false));
  }
  for (const auto& file : golden::FilesIn(kFolder, "fail_", ".txt")) {
    const Analysis analysis = AnalyzeFiles(file);
    EXPECT_TRUE(analysis.diagnostics.has_errors()) << file;
    golden::ExpectBehindInput(file, Render(analysis.sources, analysis.diagnostics, false));
  }
}

TEST(WarningMessages, AreAsReviewed) {
  for (const auto& file : golden::FilesIn(kFolder, "warn_", ".task")) {
    const Analysis analysis = AnalyzeFile(file);
    EXPECT_TRUE(analysis.task) << file;
    golden::ExpectBehindInput(file, Render(analysis.sources, analysis.diagnostics, false));
  }
  for (const auto& file : golden::FilesIn(kFolder, "warn_", ".txt")) {
    const Analysis analysis = AnalyzeFiles(file);
    EXPECT_TRUE(analysis.task) << file;
    golden::ExpectBehindInput(file, Render(analysis.sources, analysis.diagnostics, false));
  }
}

TEST(WarningMessages, ProvokeAllThatComesFromBoundsAndAllowances) {
  std::set<std::string, std::less<>> provoked;
  for (const auto& file : golden::FilesIn(kFolder, "", ".task")) {
    const Analysis analysis = AnalyzeFile(file);
    for (const Diagnostic& diagnostic : analysis.diagnostics.list())
      provoked.insert(diagnostic.code);
  }
  for (const DiagnosticKind& kind : kDiagnosticTable)
    if (IsOfAnalysis(kind.code)) {
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
