#include "runtime/analysis/study/study_document.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>

#include "runtime/analysis/study/behavior_groups.h"
#include "runtime/training/run/run_files.h"
#include "tests/runtime/analysis/study/sample_study.h"
#include "tests/runtime/theme_color.h"
#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/temporary_folder.h"
#include "tests/scoped_environment.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class StudyDocumentTest : public testing::Test {
 protected:
  void SetUp() override { runs_ = WriteStudy(study_.path()); }
  std::string Write() { return ReadText(WriteStudyDocument(study_.path(), runs_, output())); }
  std::filesystem::path output() const { return output_.path() / "results"; }

  TemporaryFolder study_;
  TemporaryFolder output_;
  std::vector<std::filesystem::path> runs_;
};

TEST_F(StudyDocumentTest, NamesWhatTheFiguresAreOf) {
  const std::string text = Write();
  EXPECT_THAT(text, HasSubstr("| [crawling](#crawling) | 7 |"));
  EXPECT_THAT(text, HasSubstr("Robot `humanoid`, task `crawling` ("));
  EXPECT_THAT(text, HasSubstr("profile `paper`, 40 episodes, seeds 1, 2, 3, 4, 5, 6, 7, 8;"));
  EXPECT_THAT(text, HasSubstr("means of the last 2 episodes"));
  EXPECT_THAT(text, HasSubstr("Settings: `task.fall_penalty = 8.0`.\n\n    trainer train tasks/"));
}

TEST_F(StudyDocumentTest, TellsOfGroupsWithTheSentencesThatPeopleWrote) {
  const std::string text = Write();
  EXPECT_THAT(text, HasSubstr("**Group A**: 71 % of the runs (seeds 1, 2, 3, 4, 5). Final return"));
  EXPECT_THAT(text, HasSubstr("**Group B**: 29 % of the runs (seeds 6, 7). Crawls fast. Final"));
}

// In the table of runs: the eighth is still at work, so it is in no group.
TEST_F(StudyDocumentTest, ListsEveryRun) {
  const std::string text = Write();
  EXPECT_THAT(text, HasSubstr("\n| 7 | 40 | "));
  EXPECT_THAT(text, HasSubstr("\n| 8 | 25 | "));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST_F(StudyDocumentTest, TellsWhatRemainsInOtherProfiles) {
  const std::string text = Write();
  EXPECT_THAT(text, HasSubstr("| return | 95 % | remains | median of the runs |"));
  EXPECT_THAT(text, HasSubstr("\n| fast | 7 | 196.7 | "));  // 0.9 * (530 + 2 * 500) / 7
  EXPECT_THAT(text, HasSubstr(" | 90 % | 90 % |\n| paper-tree | 7 | "));
}

// As gnuplot writes a color.
std::string InDrawings(uint32_t color) {
  return fmt::format("rgb({:3}, {:3}, {:3})", color >> 16, color >> 8 & 0xff, color & 0xff);
}

TEST_F(StudyDocumentTest, DrawsTheCurvesTheSameEveryTime) {
  Write();
  const std::string drawing = ReadText(output() / "crawling.svg");
  EXPECT_THAT(drawing, AllOf(StartsWith("<?xml"), HasSubstr("return, mean of 2"),
                             HasSubstr("<title>seed 7</title>"), EndsWith("</svg>\n\n")));
  // The colors of both groups, of the mean and of its interval.
  for (const char* name : {"series-1", "series-2", "ink"}) {
    EXPECT_THAT(drawing, HasSubstr(InDrawings(ThemeColor(name)))) << name;
  }
  EXPECT_THAT(drawing, HasSubstr(InDrawings(0xe1e7ed)));
  Write();
  EXPECT_EQ(ReadText(output() / "crawling.svg"), drawing);
}

TEST_F(StudyDocumentTest, SaysThatGnuplotIsMissing) {
  const ScopedEnvironment path("PATH", output_.path().string());
  EXPECT_EQ(ErrorOf([&] { Write(); }),
            "gnuplot draws the curves of crawling, and cannot be run: No such file or directory; "
            "install it (in Debian: gnuplot-nox)");
}

TEST_F(StudyDocumentTest, ShowsWhatEachGroupDoes) {
  const std::string text = Write();
  EXPECT_THAT(text, HasSubstr("![Group A: seed "));
  EXPECT_THAT(text, HasSubstr("episode 40, at 0.00, "));
  EXPECT_THAT(text, HasSubstr(" s](crawling-B.png)"));
  EXPECT_THAT(ReadText(output() / "crawling-B.png"), StartsWith("\x89PNG"));
}

TEST_F(StudyDocumentTest, SaysWhereItCannotWrite) {
  std::ofstream(output()) << "a file";
  EXPECT_THAT(ErrorOf([&] { Write(); }), HasSubstr("results: cannot be created"));
}

TEST(GroupName, CountsInLetters) {
  EXPECT_EQ(GroupName(0), "A");
  EXPECT_EQ(GroupName(25), "Z");
  EXPECT_EQ(GroupName(26), "AA");
  EXPECT_EQ(GroupName(26 * 27), "AAA");
}

}  // namespace
}  // namespace runtime
