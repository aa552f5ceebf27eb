#include "compiler/document/task_page.h"

#include <gtest/gtest.h>

#include "tests/compiler/golden.h"

namespace compiler {
namespace {

constexpr const char* kGolden = SOURCE_DIR "/tests/compiler/document/golden";

void ExpectAsReviewed(const std::filesystem::path& file) {
  Analysis analysis = Analyze(file, ReadFromDisk, SOURCE_DIR "/plugins");
  ASSERT_TRUE(analysis.task) << file;
  golden::Expect(std::filesystem::path(kGolden) / (file.stem().string() + ".md.expected"),
                 ToMarkdown(PageOf(analysis)));
}

TEST(TaskPage, OfThePapersTasksIsAsReviewed) {
  for (const auto& file : golden::FilesIn(SOURCE_DIR "/tasks", "", ".task")) ExpectAsReviewed(file);
}

TEST(TaskPage, OfATaskWithAllPartsIsAsReviewed) {
  for (const auto& file : golden::FilesIn(kGolden, "", ".task")) ExpectAsReviewed(file);
}

}  // namespace
}  // namespace compiler
