// The messages of the checker, word for word: messages/fail_*.task are wrong, messages/warn_*.task
// only get warnings; behind each task stands all that is said about it.
#include <filesystem>
#include <set>

#include "compiler/source/diagnostic_table.h"
#include "tests/compiler/check/analysis_codes.h"
#include "tests/compiler/check/checked_source.h"
#include "tests/golden.h"

namespace compiler {
namespace {

const std::filesystem::path kFolder = SOURCE_DIR "/tests/compiler/check/messages";

// A task of the folder, under a path that does not depend on where the project lies.
CheckedSource CheckFile(const std::filesystem::path& file) {
  return CheckedSource(file.filename(), golden::ReadInput(file));
}

void ExpectMessages(const std::filesystem::path& file, const CheckedSource& checked) {
  EXPECT_TRUE(checked.is_parsed) << file << "\n" << checked.Messages();
  golden::ExpectBehindInput(file, checked.Messages());
}

TEST(Messages, OfWrongTasksAreAsReviewed) {
  for (const auto& file : golden::FilesIn(kFolder, "fail_", ".task")) {
    const CheckedSource checked = CheckFile(file);
    EXPECT_FALSE(checked.task) << file;
    EXPECT_TRUE(checked.diagnostics.has_errors()) << file;
    ExpectMessages(file, checked);
  }
}

TEST(Messages, OfCarelessTasksAreAsReviewed) {
  for (const auto& file : golden::FilesIn(kFolder, "warn_", ".task")) {
    const CheckedSource checked = CheckFile(file);
    EXPECT_TRUE(checked.task) << file;
    ExpectMessages(file, checked);
  }
}

TEST(Messages, AreCaseAndPeriodAsTheGuideAsks) {
  for (const auto& file : golden::FilesIn(kFolder, "", ".task")) {
    const CheckedSource checked = CheckFile(file);
    for (const Diagnostic& diagnostic : checked.diagnostics.list()) {
      EXPECT_FALSE(std::isupper(static_cast<unsigned char>(diagnostic.message.front())))
          << diagnostic.message;
      EXPECT_FALSE(diagnostic.message.ends_with('.')) << diagnostic.message;
      const bool is_of_file = diagnostic.code == code::kNotATable;  // perhaps of an empty one
      EXPECT_TRUE(is_of_file || diagnostic.span.begin < diagnostic.span.end) << diagnostic.message;
    }
  }
}

TEST(Messages, ProvokeEveryDiagnosticOfTheChecker) {
  std::set<std::string> provoked;
  for (const auto& file : golden::FilesIn(kFolder, "", ".task")) {
    const CheckedSource checked = CheckFile(file);
    for (const Diagnostic& diagnostic : checked.diagnostics.list())
      provoked.insert(diagnostic.code);
  }
  for (const DiagnosticKind& kind : kDiagnosticTable) {
    const bool is_syntax = kind.code.starts_with("E01") || kind.code == code::kMisplacedPotential;
    // The files of a task are merged, and the robot is looked for, before a task is checked.
    const bool is_of_files = kind.code.starts_with("E063") || kind.code == code::kOtherKindOfReward;
    const bool is_of_checker =
        !is_syntax && !is_of_files && !IsOfAnalysis(kind.code) && kind.code != code::kUnknownRobot;
    if (is_of_checker) {
      EXPECT_TRUE(provoked.contains(std::string(kind.code))) << kind.code;
    }
  }
}

}  // namespace
}  // namespace compiler
