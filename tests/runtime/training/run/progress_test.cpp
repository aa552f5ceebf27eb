#include "runtime/training/run/progress.h"

#include <gmock/gmock.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <tuple>

#include "tests/runtime/training/run/sample_run.h"
#include "tests/screen.h"
#include "tests/terminal.h"

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

// On a terminal of 24 rows.
class ProgressOnTerminalTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!HasTerminals()) GTEST_SKIP() << "there are no terminals here";
    unsetenv("NO_COLOR");
    setenv("TERM", "xterm", 1);
    int program = -1;
    const winsize size{24, kColumns, 0, 0};
    ASSERT_EQ(openpty(&terminal_, &program, nullptr, nullptr, &size), 0);
    output_ = fdopen(program, "w");
  }
  void TearDown() override {
    if (output_ != nullptr) std::fclose(output_);
    if (terminal_ >= 0) close(terminal_);
  }
  // All that stands there once `last` does.
  std::string Screen(const std::string& last) {
    pollfd readable = {terminal_, POLLIN, 0};
    while (printed_.find(last) == std::string::npos && poll(&readable, 1, 20'000) == 1) {
      char bytes[1000];
      const ssize_t size = read(terminal_, bytes, sizeof bytes);
      if (size <= 0) break;
      printed_.append(bytes, static_cast<size_t>(size));
    }
    std::string text;
    for (const std::string& line : ScreenLines(printed_, kColumns)) text += line + "\n";
    return text;
  }
  void Finish(Progress& progress, int number) {
    statistics_.Add(SampleEpisode(number));
    progress.FinishEpisode(SampleEpisode(number), statistics_);
  }

  static constexpr unsigned short kColumns = 60;
  int terminal_ = -1;
  std::FILE* output_ = nullptr;
  std::string printed_;
  ReturnStatistics statistics_;
};

TEST_F(ProgressOnTerminalTest, KeepsAPictureUpToDateBelowWhatIsSaid) {
  RunRecord run = SampleRun();
  run.episodes_planned = 3;
  Progress progress(ProgressStyle::kText, run, output_, output_);
  progress.Recall(SampleEpisode(1));
  Finish(progress, 2);
  progress.Warn("warning: something");
  Finish(progress, 3);
  EXPECT_TRUE(progress.is_live());
  progress.Leave();
  progress.Note("done");
  EXPECT_THAT(Screen("done"),
              testing::MatchesRegex("warning: something *\n"
                                    "episode 3/3  (█)+  100 %  0:00 left *\n"
                                    "return 0.3  mean of 20 0.25  best 0.3  ▁(▄|▅)█ *\n"
                                    "  speed +0.3333  (█)+▍ *\n"
                                    "  fall +-4  (▒)+ *\n"
                                    "[^\n]*x real time  0:00 elapsed *\n"
                                    "done\n\n"));
}

TEST_F(ProgressOnTerminalTest, PrintsLinesThatStayWhereTheUserWantsThat) {
  for (const auto& [style, no_color, terminal] : {std::tuple(ProgressStyle::kPlain, "", "xterm"),
                                                  {ProgressStyle::kText, "1", "xterm"},
                                                  {ProgressStyle::kText, "", "dumb"}}) {
    printed_.clear();
    setenv("NO_COLOR", no_color, 1);
    setenv("TERM", terminal, 1);
    RunRecord run = SampleRun();
    run.episodes_planned = 2;
    Progress progress(style, run, output_, output_);
    Finish(progress, 1);
    Finish(progress, 2);
    progress.Note("done");
    EXPECT_THAT(Screen("done"), testing::HasSubstr("episode 1/2  return 0.1  "));
    EXPECT_THAT(printed_, testing::Not(testing::HasSubstr("\x1b")));
    statistics_ = {};
  }
  unsetenv("NO_COLOR");
}

}  // namespace
}  // namespace runtime
