#include "runtime/training/run/progress.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/runtime/training/run/sample_run.h"

namespace runtime {
namespace {

// What a Progress of this style prints to a file while three episodes with returns 0.1, 0.2, 0.3
// end.
struct Printed {
  std::string output;
  std::string warnings;
};

std::string Contents(std::FILE* file) {
  std::rewind(file);
  std::string text(10'000, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  std::fclose(file);
  return text;
}

Printed PrintThreeEpisodes(ProgressStyle style) {
  RunRecord run = SampleRun();
  run.episodes_planned = 3;
  std::FILE* output = std::tmpfile();
  std::FILE* warnings = std::tmpfile();
  {
    Progress progress(style, run, output, warnings);
    ReturnStatistics statistics;
    for (int number = 1; number <= 3; ++number) {
      statistics.Add(SampleEpisode(number));
      progress.FinishEpisode(SampleEpisode(number), statistics);
    }
    progress.Warn("warning: something");
    progress.Note("done");
  }
  return {Contents(output), Contents(warnings)};
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
  EXPECT_THAT(ProgressLine(values), testing::HasSubstr("  best none  "));
}

TEST(DurationText, ShowsHoursOnlyWhereThereAreSome) {
  EXPECT_EQ(DurationText(0), "0:00");
  EXPECT_EQ(DurationText(59.99), "0:59");
  EXPECT_EQ(DurationText(3599), "59:59");
  EXPECT_EQ(DurationText(3723), "1:02:03");
  EXPECT_EQ(DurationText(-1), "0:00");
}

TEST(EpisodeJson, NamesTermsMetricsAndLogs) {
  EpisodeRecord episode = SampleEpisode(7);
  episode.active.end_reason = "fell \"badly\"";
  episode.active.metrics = {std::nan("")};
  episode.active.logs[1] = std::nan("");
  // A number that is none is written as null.
  const auto json = nlohmann::json::parse(EpisodeJson(episode, SampleRun()).dump());
  EXPECT_EQ(json["episode"], 7);
  EXPECT_EQ(json["task"], "crawling");
  EXPECT_EQ(json["return"].get<double>(), episode.active.episode_return);
  EXPECT_EQ(json["end"]["kind"], "truncated");
  EXPECT_EQ(json["end"]["reason"], "fell \"badly\"");
  EXPECT_EQ(json["terms"]["speed"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(json["terms"]["fall"], -4);
  EXPECT_TRUE(json["metrics"]["distance"].is_null());
  EXPECT_EQ(json["logs"]["speed"], 0.125);
  EXPECT_TRUE(json["logs"]["falls"].is_null());
  EXPECT_EQ(json["violations"], 3);
  EXPECT_EQ(json["steps"], 4007);
  EXPECT_EQ(json["actions"], 80);
  EXPECT_EQ(json["faults"], 2);
  EXPECT_EQ(json["cpu_seconds"], 4.25);
  EXPECT_EQ(json["learner"], nlohmann::json::object());
  EXPECT_FALSE(json.contains("shadows"));
}

TEST(EpisodeJson, TellsGoalsAndPhasesAsTheRecordHasThem) {
  const auto json = nlohmann::json::parse(EpisodeJson(SampleEpisode(7), SampleRun()).dump());
  const TaskRecord task = SampleTask();
  ASSERT_EQ(json["goals"].size(), 2u);
  EXPECT_EQ(json["goals"][1]["name"], task.goals[0].name);
  EXPECT_EQ(json["goals"][1]["time"], 3.005);
  EXPECT_EQ(json["goals"][1]["value"], (std::vector<double>{1e-9, 1.0 / 3.0}));
  ASSERT_EQ(json["phases"].size(), 2u);
  EXPECT_EQ(json["phases"][task.phases[1].name]["time"], 18.505);
  EXPECT_EQ(json["phases"][task.phases[1].name]["return"], -4.0 / 3.0);
}

TEST(EpisodeJson, TellsWhatTheLearnerShows) {
  EpisodeRecord episode = SampleEpisode(7);
  episode.learner = {{"rate", 0.25}, {"loss", std::nan("")}};
  const auto json = nlohmann::json::parse(EpisodeJson(episode, SampleRun()).dump());
  EXPECT_EQ(json["learner"]["rate"], 0.25);
  EXPECT_TRUE(json["learner"]["loss"].is_null());
}

TEST(EpisodeJson, TellsWhatShadowsSay) {
  RunRecord run = SampleRun();
  run.tasks.push_back(SampleVersion());
  run.tasks.back().module = "careful";
  EpisodeRecord episode = SampleEpisode(7);
  episode.shadows = {SampleShadow()};
  const nlohmann::json json = EpisodeJson(episode, run);
  const nlohmann::json& shadow = json["shadows"]["careful"];
  EXPECT_EQ(shadow["return"], -1.5);
  EXPECT_EQ(shadow["end"]["kind"], "failure");
  EXPECT_EQ(shadow["end"]["reason"], "fell");
  EXPECT_EQ(shadow["terms"], (nlohmann::json{{"effort", 0.5}, {"speed", 1}, {"fall", -4}}));
  EXPECT_EQ(shadow["metrics"], (nlohmann::json{{"distance", 0.75}}));
  EXPECT_EQ(shadow["logs"], nlohmann::json::object());
}

TEST(Progress, WritesPlainLinesWhereThereIsNoTerminal) {
  const Printed printed = PrintThreeEpisodes(ProgressStyle::kText);
  // The first, the last, and none in between within so short a time.
  EXPECT_THAT(printed.output,
              testing::MatchesRegex("episode 1/3  return 0.1 [^\n]*\nepisode 3/3  return 0.3  "
                                    "mean of 20 0.2  best 0.3 [^\n]*\ndone\n"));
  EXPECT_EQ(printed.output.find_first_of("\r\x1b"), std::string::npos);
  EXPECT_EQ(printed.warnings, "warning: something\n");
}

TEST(Progress, WritesOneJsonObjectPerEpisodeAndNothingElse) {
  std::istringstream output(PrintThreeEpisodes(ProgressStyle::kJson).output);
  int episodes = 0;
  for (std::string line; std::getline(output, line);) {
    EXPECT_EQ(nlohmann::json::parse(line)["episode"], ++episodes);
  }
  EXPECT_EQ(episodes, 3);
}

TEST(Progress, WarnsEvenWhenQuiet) {
  const Printed printed = PrintThreeEpisodes(ProgressStyle::kQuiet);
  EXPECT_EQ(printed.output, "");
  EXPECT_EQ(printed.warnings, "warning: something\n");
}

}  // namespace
}  // namespace runtime
