#include "runtime/training/run/progress_screen.h"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "base/text/utf8.h"
#include "runtime/training/run/return_statistics.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// 340 of 1000 episodes, whose returns have grown from 0 to 12.25.
ProgressPicture Picture() {
  ProgressPicture picture;
  picture.values = {.episode = 340,
                    .episodes_planned = 1000,
                    .last_return = 12.25,
                    .mean = 11.4,
                    .best_return = 27.61,
                    .simulated_seconds_per_second = 98.1,
                    .elapsed = 55,
                    .remaining = 107};
  for (int i = 0; i < 340; ++i) picture.history.Add(12.25 * i / 339);
  picture.terms = {{"forward", 12.9}, {"turning", -1.4999}, {"fall", 0}};
  return picture;
}

std::vector<std::string> Lines(const std::string& screen) {
  std::istringstream stream(screen);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(ProgressLine, SaysEverythingInOneLine) {
  ProgressValues values;
  values.episode = 12;
  values.episodes_planned = 1000;
  values.last_return = -3.25;
  values.mean = -4.1;
  values.best_return = 1.5;
  values.simulated_seconds_per_second = 4.23;
  values.elapsed = 5.9;
  values.remaining = 400;
  EXPECT_EQ(ProgressLine(values),
            "episode 12/1000  return -3.25  mean of 20 -4.1  best 1.5  4.2x real time  "
            "0:05 elapsed  6:40 left");
}

TEST(ProgressLine, NeverCutsANumber) {
  ProgressValues values;
  values.episode = 120;
  values.episodes_planned = 1000;
  values.last_return = 37.58;
  values.mean = 36.11;
  values.best_return = 37.58;
  values.simulated_seconds_per_second = 4.23;
  values.remaining = 400;
  EXPECT_EQ(ProgressLine(values, 79),
            "episode 120/1000  return 37.58  mean of 20 36.11  best 37.58  6:40 left");
  EXPECT_EQ(ProgressLine(values, 59), "episode 120/1000  mean of 20 36.11  best 37.58  6:40 left");
  EXPECT_EQ(ProgressLine(values, 39), "episode 120/1000  best 37.58  6:40 left");
  EXPECT_EQ(ProgressLine(values, 16), "episode 120/1000");
}

TEST(ProgressLine, KnowsNoBestWhileEverythingDiverges) {
  ProgressValues values;
  values.best_return = ReturnStatistics().best();
  EXPECT_THAT(ProgressLine(values), HasSubstr("  best none  "));
}

TEST(DurationText, ShowsHoursOnlyWhereThereAreSome) {
  EXPECT_EQ(DurationText(0), "0:00");
  EXPECT_EQ(DurationText(59.99), "0:59");
  EXPECT_EQ(DurationText(3599), "59:59");
  EXPECT_EQ(DurationText(3723), "1:02:03");
  EXPECT_EQ(DurationText(-1), "0:00");
}

TEST(ProgressScreen, ShowsHowTheRunGoes) {
  const std::vector<std::string> lines = Lines(ProgressScreen(Picture(), 79, 20));
  ASSERT_EQ(lines.size(), 6u);
  // 34 % of 40 characters are 13.6.
  EXPECT_EQ(lines[0],
            "episode 340/1000  █████████████▋░░░░░░░░░░░░░░░░░░░░░░░░░░  34 %  1:47 left");
  EXPECT_THAT(lines[1], testing::MatchesRegex(
                            "return 12.25  mean of 20 11.4  best 27.61  ▁(▁|▂|▃|▄|▅|▆|▇|█)+█"));
  EXPECT_EQ(lines[2], "  forward  12.9  ████████████████████████████████████████");
  EXPECT_EQ(lines[3], "  turning  -1.5  ▒▒▒▒▒");
  EXPECT_EQ(lines[4], "  fall        0");
  EXPECT_EQ(lines[5], "98.1x real time  0:55 elapsed");
}

TEST(ProgressScreen, FitsEveryWindow) {
  for (const size_t columns : {9u, 20u, 39u, 50u, 79u, 200u}) {
    for (const size_t rows : {1u, 2u, 4u, 6u, 50u}) {
      const std::vector<std::string> lines = Lines(ProgressScreen(Picture(), columns, rows));
      EXPECT_LE(lines.size(), rows);
      for (const std::string& line : lines) EXPECT_LE(text::DisplayWidth(line), columns) << line;
    }
  }
  EXPECT_EQ(ProgressScreen(Picture(), 39, 1), "episode 340/1000  34 %  1:47 left\n");
  EXPECT_EQ(ProgressScreen(Picture(), 20, 2), "episode 340/1000\nmean of 20 11.4\n");
}

TEST(ProgressScreen, ShowsTheTermsThatAreWorthMost) {
  ProgressPicture picture = Picture();
  picture.terms = {{"small", 0.1}, {"large", 5}, {"taken", -3}, {"none", NAN}};
  const std::string screen = ProgressScreen(picture, 79, 5);
  EXPECT_THAT(screen, AllOf(HasSubstr("  large"), HasSubstr("  taken"), Not(HasSubstr("small"))));
  for (int i = 0; i < 20; ++i) picture.terms.push_back({"term" + std::to_string(i), 10.});
  EXPECT_EQ(Lines(ProgressScreen(picture, 79, 50)).size(), 3u + 8u);
}

}  // namespace
}  // namespace runtime
