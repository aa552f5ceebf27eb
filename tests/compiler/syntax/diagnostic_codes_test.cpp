// Every diagnostic is documented, and some test provokes it.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "compiler/source/diagnostic_table.h"
#include "tests/golden.h"

namespace compiler {
namespace {

// All sources and reviewed outputs of the compiler's tests.
std::string TestTexts() {
  std::string texts;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(SOURCE_DIR "/tests/compiler")) {
    const std::string extension = entry.path().extension();
    if (extension == ".expected" || extension == ".cpp") texts += golden::ReadFile(entry.path());
    if (extension == ".task" || extension == ".txt")
      texts += golden::Split(entry.path(), golden::ReadFile(entry.path())).section;
  }
  return texts;
}

TEST(DiagnosticCodes, AreDocumented) {
  const std::string page = golden::ReadFile(SOURCE_DIR "/docs/diagnostics.md");
  for (const DiagnosticKind& kind : kDiagnosticTable) {
    const std::string heading = "\n### " + std::string(kind.code) + ": " + std::string(kind.title);
    EXPECT_TRUE(page.find(heading + "\n") != std::string::npos) << "no heading:" << heading;
  }
}

TEST(DiagnosticCodes, AreProvokedBySomeTest) {
  const std::string texts = TestTexts();
  for (const DiagnosticKind& kind : kDiagnosticTable) {
    EXPECT_TRUE(texts.find(kind.code) != std::string::npos) << kind.code << " " << kind.title;
  }
}

}  // namespace
}  // namespace compiler
