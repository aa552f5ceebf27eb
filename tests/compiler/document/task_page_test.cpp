#include "compiler/document/task_page.h"

#include <gtest/gtest.h>

#include "compiler/document/task_json.h"
#include "tests/golden.h"

namespace compiler {
namespace {

constexpr const char* kGolden = SOURCE_DIR "/tests/compiler/document/golden";

// Without what differs from machine to machine, and at every change of a comment.
std::string JsonOf(const Analysis& analysis) {
  Json json = ToJson(analysis);
  json.erase("file");
  json.erase("hash");
  for (Json& phase : json["phases"])
    for (Json& next : phase["next"]) next.erase("file");
  return ToText(json);
}

// The page and the data.
void ExpectAsReviewed(const std::filesystem::path& file) {
  Analysis analysis = Analyze(file, ReadFromDisk, SOURCE_DIR "/plugins");
  ASSERT_TRUE(analysis.task) << file;
  const std::filesystem::path golden = std::filesystem::path(kGolden) / file.stem();
  golden::Expect(golden.string() + ".md.expected", ToMarkdown(PageOf(analysis)));
  golden::Expect(golden.string() + ".json.expected", JsonOf(analysis));
}

TEST(TaskPage, OfThePapersTasksIsAsReviewed) {
  for (const auto& file : golden::FilesIn(SOURCE_DIR "/tasks", "", ".task")) ExpectAsReviewed(file);
}

TEST(TaskPage, OfATaskWithAllPartsIsAsReviewed) {
  for (const auto& file : golden::FilesIn(kGolden, "", ".task")) ExpectAsReviewed(file);
}

TEST(TaskPage, DrawsThePhases) {
  const Analysis analysis =
      Analyze(std::string(kGolden) + "/phases.task", ReadFromDisk, SOURCE_DIR "/plugins");
  ASSERT_TRUE(analysis.task);
  golden::Expect(std::string(kGolden) + "/phases.svg.expected", ToSvg(AutomatonOf(analysis)));
}

}  // namespace
}  // namespace compiler
