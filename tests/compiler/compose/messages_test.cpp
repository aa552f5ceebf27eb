// What is wrong between files, as a person reads it. A golden file in `messages` holds files, see
// SplitFiles(), and behind them what is said of `main.task`.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/compiler/compose/file_set.h"
#include "tests/golden.h"

namespace compiler {
namespace {

const std::filesystem::path kFolder = SOURCE_DIR "/tests/compiler/compose/messages";

TEST(ComposeMessages, AreAsReviewed) {
  for (const auto& path : golden::FilesIn(kFolder, "fail_", ".txt")) {
    const Composed composed(SplitFiles(golden::ReadInput(path)));
    EXPECT_TRUE(composed.diagnostics.has_errors()) << path;
    golden::ExpectBehindInput(path, composed.Messages());
  }
}

TEST(ComposeMessages, SuggestAFileOfTheFolder) {
  const std::filesystem::path folder = testing::TempDir() + "/taskc_compose_test";
  std::filesystem::create_directories(folder);
  for (const char* name : {"shaping.task", "other.task", "shapin.txt"})
    std::ofstream(folder / name) << "";
  std::ofstream(folder / "main.task") << "task t\nimport \"shapng.task\"\n";
  Sources sources;
  Diagnostics diagnostics;
  Compose(folder / "main.task", ReadFromDisk, sources, diagnostics);
  ASSERT_EQ(diagnostics.list().size(), 1u);
  EXPECT_EQ(diagnostics.list()[0].code, code::kMissingFile);
  EXPECT_EQ(diagnostics.list()[0].help.text, "did you mean `shaping.task`?");
  std::filesystem::remove_all(folder);
}

TEST(ComposeMessages, SuggestATableOfTheFolder) {
  const std::filesystem::path folder = testing::TempDir() + "/taskc_table_test";
  std::filesystem::create_directories(folder / "folder.csv");
  for (const char* name : {"walk.csv", "walks.task"}) std::ofstream(folder / name) << "";
  std::ofstream(folder / "main.task")
      << "task t\ntable a: real = \"walks.csv\"\ntable b: real = \"folder.csv\"\n";
  Sources sources;
  Diagnostics diagnostics;
  Compose(folder / "main.task", ReadFromDisk, sources, diagnostics);
  ASSERT_EQ(diagnostics.list().size(), 2u);
  EXPECT_EQ(diagnostics.list()[0].help.text, "did you mean `walk.csv`?");
  EXPECT_EQ(diagnostics.list()[1].code, code::kMissingFile);
  EXPECT_EQ(diagnostics.list()[1].help.text, "it is a folder; name a regular file");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace compiler
