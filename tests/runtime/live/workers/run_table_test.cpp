#include "runtime/live/workers/run_table.h"

#include <gmock/gmock.h>

#include <limits>
#include <sstream>

#include "base/text/utf8.h"

namespace runtime {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::SizeIs;

std::vector<RunProgress> TwoRuns() {
  RunProgress running{"", "crawling-fast-tree/seed1"};
  running.state = RunProgressState::kRunning;
  running.episodes = 340;
  running.episodes_planned = 1000;
  running.last_return = 12.25;
  running.best_return = 37.58;
  running.wall_seconds = 340;
  running.episodes_here = 340;
  RunProgress waiting{"", "crawling-fast-tree/seed2"};
  waiting.episodes_planned = 1000;
  return {running, waiting};
}

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(RunTable, ShowsAllWhereThereIsRoom) {
  EXPECT_THAT(
      Lines(RunTable(TwoRuns(), 79)),
      ElementsAre("run                       state        episodes       last       best      left",
                  "crawling-fast-tree/seed1  running      340/1000      12.25      37.58     11:00",
                  "crawling-fast-tree/seed2  waiting        0/1000          -          -"));
  EXPECT_EQ(RunTable(TwoRuns(), 79), RunTable(TwoRuns()));
}

TEST(RunTable, LeavesOutWholeColumns) {
  EXPECT_THAT(Lines(RunTable(TwoRuns(), 59)),
              ElementsAre("run                       state        episodes      left",
                          "crawling-fast-tree/seed1  running      340/1000     11:00",
                          "crawling-fast-tree/seed2  waiting        0/1000"));
  EXPECT_THAT(Lines(RunTable(TwoRuns(), 39)), ElementsAre("run                          episodes",
                                                          "crawling-fast-tree/seed1     340/1000",
                                                          "crawling-fast-tree/seed2       0/1000"));
}

TEST(RunTable, KeepsTheEndsOfLongNames) {
  EXPECT_THAT(Lines(RunTable(TwoRuns(), 24)),
              ElementsAre("run             episodes", "…tree/seed1     340/1000",
                          "…tree/seed2       0/1000"));
}

TEST(RunTable, NeverIsWiderThanTheTerminal) {
  std::vector<RunProgress> runs = TwoRuns();
  runs[0].best_return = -123456789.125;
  runs[0].episodes_planned = 100'000'000;
  for (size_t columns = 24; columns < 130; ++columns) {
    for (const std::string& line : Lines(RunTable(runs, columns))) {
      EXPECT_LE(text::DisplayWidth(line), columns) << line;
    }
  }
}

TEST(RunSummary, DropsTheStatesBeforeTheTimeLeft) {
  EXPECT_EQ(RunSummary(TwoRuns(), 1), "1 running, 1 waiting   340/2000 episodes   27:40 left");
  EXPECT_EQ(RunSummary(TwoRuns(), 1, 39), "340/2000 episodes   27:40 left");
  EXPECT_EQ(RunSummary(TwoRuns(), 1, 20), "340/2000 episodes");
}

}  // namespace
}  // namespace runtime
