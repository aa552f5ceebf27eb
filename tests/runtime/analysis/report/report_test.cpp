#include "runtime/analysis/report/report.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <regex>

#include "runtime/training/run/compression.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/run/timeline.h"
#include "tests/runtime/analysis/report/report_page.h"
#include "tests/runtime/analysis/report/sample_run.h"
#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

EpisodeRecord Episode(int64_t number, double value) {
  EpisodeRecord episode;
  episode.number = number;
  episode.active.task = 1;
  episode.active.episode_return = value;
  episode.active.end_kind = "truncated";
  episode.active.end_reason = "time is up";
  episode.simulated_seconds = 20;
  episode.wall_seconds = 2;
  episode.active.terms = {value + 1, -1, 0};
  episode.active.metrics = {0.5, 0};
  episode.active.logs = {number == 1 ? 0.25 : NAN};
  episode.active.violations = number;
  return episode;
}

// A recording of two links with these values.
Recording TwoLinks(const std::vector<float>& poses) {
  return {static_cast<int64_t>(poses.size() / 14), 0.02, false,
          Compress(std::as_bytes(std::span(poses))), ""};
}

std::vector<float> Frames(size_t count) {
  std::vector<float> poses(count * 14);
  for (size_t i = 0; i < poses.size(); ++i) poses[i] = 0.5f * static_cast<float>(i);
  return poses;
}

class WriteReportTest : public testing::Test {
 protected:
  WriteReportTest() {
    run_.body =
        R"([{"name": "body", "shape": "box", "size": [1, 1, 1], "radius": 0, "length": 0, "axis": 0},
            {"name": "foot", "shape": "sphere", "size": [0, 0, 0], "radius": 1, "length": 0,
             "axis": 0}])";
  }
  RunDatabase Create() { return RunDatabase::Create(folder(), run_); }
  json Data() { return DataOfPage(WriteReport(folder())); }
  std::filesystem::path folder() const { return folder_.path() / "run"; }

  RunRecord run_ = SampleRunRecord();
  TemporaryFolder folder_;
};

TEST_F(WriteReportTest, TellsTheValuesOfEachEpisode) {
  RunDatabase database = Create();
  database.AddEpisode(Episode(1, -2.5), std::nullopt, std::nullopt);
  database.AddEpisode(Episode(2, NAN), std::nullopt, std::nullopt);
  const json data = Data();
  EXPECT_THAT(Floats(data["episode"]), ElementsAre(1, 2));
  EXPECT_THAT(Floats(data["returns"]), ElementsAre(-2.5f, testing::NanSensitiveFloatEq(kNan)));
  ASSERT_THAT(data["terms"], SizeIs(3));
  EXPECT_EQ(data["terms"][0]["name"], "forward");
  EXPECT_THAT(Floats(data["terms"][0]["values"]),
              ElementsAre(-1.5f, testing::NanSensitiveFloatEq(kNan)));
  ASSERT_THAT(data["metrics"], SizeIs(2));
  EXPECT_EQ(data["metrics"][0]["unit"], "m");
  EXPECT_EQ(data["metrics"][1]["reduction"], "sum");
  EXPECT_THAT(Floats(data["metrics"][0]["values"]), ElementsAre(0.5f, 0.5f));
  ASSERT_THAT(data["logs"], SizeIs(1));
  EXPECT_EQ(data["logs"][0]["name"], "speed");
  EXPECT_EQ(data["logs"][0]["reduction"], "mean");
  EXPECT_THAT(Floats(data["logs"][0]["values"]),
              ElementsAre(0.25f, testing::NanSensitiveFloatEq(kNan)));
  EXPECT_EQ(data["violations"], 3);
}

TEST_F(WriteReportTest, TellsOfEachElementOfAGoalTheMeanOverTheEpisode) {
  run_.tasks[0].goals = {{"command", "vec2", "m/s", "how fast"}, {"side", "int", "", ""}};
  RunDatabase database = Create();
  EpisodeRecord first = Episode(1, 0);  // of 20 s
  first.active.goals = {{0, 0, {1, 0}}, {1, 0, {-1}}, {0, 5, {0, 2}}};
  database.AddEpisode(first, std::nullopt, std::nullopt);
  EpisodeRecord second = Episode(2, 0);
  second.active.goals = {{0, 0, {0.5, 0.5}}};
  database.AddEpisode(second, std::nullopt, std::nullopt);
  const json goals = Data()["goals"];
  ASSERT_THAT(goals, SizeIs(3));
  EXPECT_EQ(goals[0]["name"], "command.x");
  EXPECT_EQ(goals[0]["unit"], "m/s");
  EXPECT_EQ(goals[0]["doc"], "how fast");
  EXPECT_THAT(Floats(goals[0]["values"]), ElementsAre(0.25f, 0.5f));
  EXPECT_EQ(goals[1]["name"], "command.y");
  EXPECT_THAT(Floats(goals[1]["values"]), ElementsAre(1.5f, 0.5f));
  EXPECT_EQ(goals[2]["name"], "side");
  EXPECT_THAT(Floats(goals[2]["values"]), ElementsAre(-1.0f, testing::NanSensitiveFloatEq(kNan)));
}

TEST_F(WriteReportTest, TellsBesideARecordingWhatTheRobotWasTold) {
  run_.tasks[0].goals = {{"side", "int", "", ""}};
  RunDatabase database = Create();
  EpisodeRecord episode = Episode(1, 0);
  episode.active.goals = {{0, 0, {-1}}, {0, 2.5, {1}}};
  database.AddEpisode(episode, TwoLinks(Frames(2)), std::nullopt);
  const json data = Data();
  ASSERT_THAT(data["recordings"], SizeIs(1));
  EXPECT_EQ(
      data["recordings"][0]["goals"],
      json::parse(R"([{"time": 0.0, "name": "side", "type": "int", "unit": "", "value": [-1.0]},
                            {"time": 2.5, "name": "side", "type": "int", "unit": "", "value": [1.0]}])"));
}

TEST_F(WriteReportTest, TellsHowLongEachPhaseHasLastedAndWhatWasPaidInIt) {
  run_.tasks[0].phases = {{"reach", ""}, {"lift", "up"}};
  RunDatabase database = Create();
  EpisodeRecord first = Episode(1, 0);
  first.active.phases = {{1.5, 2}, {0.5, -1}};
  database.AddEpisode(first, std::nullopt, std::nullopt);
  const json phases = Data()["phases"];
  ASSERT_THAT(phases, SizeIs(4));
  EXPECT_EQ(phases[0]["name"], "reach: time");
  EXPECT_EQ(phases[0]["unit"], "s");
  EXPECT_THAT(Floats(phases[0]["values"]), ElementsAre(1.5f));
  EXPECT_EQ(phases[3]["name"], "lift: return");
  EXPECT_EQ(phases[3]["doc"], "up");
  EXPECT_THAT(Floats(phases[3]["values"]), ElementsAre(-1.0f));
}

TEST_F(WriteReportTest, TellsWhatTheLearnerHasShown) {
  RunDatabase database = Create();
  database.SetLearnerCurves({{"rate", "", "", "alpha"}, {"loss", "m", "", ""}});
  EpisodeRecord first = Episode(1, 0);
  first.learner = {{"rate", 0.5}};
  database.AddEpisode(first, std::nullopt, std::nullopt);
  EpisodeRecord second = Episode(2, 0);
  second.learner = {{"loss", 2}, {"rate", 0.25}};
  database.AddEpisode(second, std::nullopt, std::nullopt);
  const json learner = Data()["learner"];
  ASSERT_THAT(learner, SizeIs(2));
  EXPECT_EQ(learner[0]["name"], "rate");
  EXPECT_EQ(learner[0]["doc"], "alpha");
  EXPECT_THAT(Floats(learner[0]["values"]), ElementsAre(0.5f, 0.25f));
  EXPECT_EQ(learner[1]["unit"], "m");
  EXPECT_THAT(Floats(learner[1]["values"]), ElementsAre(testing::NanSensitiveFloatEq(kNan), 2.0f));
}

TEST_F(WriteReportTest, CurvesOfTheSameNameInSeveralTasksAreOne) {
  WriteTunedRun(folder());
  const json data = Data();
  std::vector<std::string> names;
  for (const json& term : data["terms"]) names.push_back(term["name"]);
  EXPECT_THAT(names, ElementsAre("forward", "turning", "fall", "effort"));
  EXPECT_EQ(data["terms"][0]["tasks"], (json{0, 2}));
  EXPECT_EQ(data["terms"][1]["tasks"], (json{0}));
  EXPECT_EQ(data["terms"][3]["tasks"], (json{2}));
  for (const float value : Floats(data["terms"][0]["values"])) EXPECT_TRUE(std::isfinite(value));
  const std::vector<float> turning = Floats(data["terms"][1]["values"]);
  const std::vector<float> effort = Floats(data["terms"][3]["values"]);
  for (size_t i = 0; i < 400; ++i) {
    EXPECT_EQ(std::isfinite(turning[i]), i < 250) << i;
    EXPECT_EQ(std::isfinite(effort[i]), i >= 250) << i;
  }
  EXPECT_THAT(data["metrics"], SizeIs(3));
}

TEST_F(WriteReportTest, TellsWhichTaskRanWhenAndWhatTheShadowsSaid) {
  WriteTunedRun(folder());
  const json data = Data();
  EXPECT_EQ(data["run"]["task_hash"], "c0ffee5b7a1e");
  ASSERT_THAT(data["tasks"], SizeIs(3));
  EXPECT_EQ(data["tasks"][1]["module"], "careful");
  EXPECT_EQ(data["versions"], (json{{{"task", 0}, {"first", 1}, {"last", 250}},
                                    {{"task", 2}, {"first", 251}, {"last", 400}}}));
  ASSERT_THAT(data["shadows"], SizeIs(1));
  EXPECT_EQ(data["shadows"][0]["module"], "careful");
  EXPECT_EQ(data["shadows"][0]["tasks"], (json{1}));
  const std::vector<float> returns = Floats(data["shadows"][0]["values"]);
  EXPECT_TRUE(std::isnan(returns[99]));
  const std::vector<EpisodeRecord> episodes = RunDatabase::OpenToRead(folder()).ReadEpisodes();
  EXPECT_EQ(returns[100], static_cast<float>(episodes[100].shadows[0].episode_return));
  EXPECT_EQ(returns[399], static_cast<float>(episodes[399].shadows[0].episode_return));
}

TEST_F(WriteReportTest, TellsTheChangesInTheOrderInWhichTheyTookEffect) {
  WriteTunedRun(folder());
  const json changes = Data()["changes"];
  ASSERT_THAT(changes, SizeIs(4));
  EXPECT_EQ(changes[1], (json{{"episode", 180},
                              {"step", 1250},
                              {"at", "2026-01-02T03:09:10Z"},
                              {"kind", "set"},
                              {"text", "set learner.temperature = 0.5"}}));
  EXPECT_EQ(changes[3]["text"], "set task.weight = 2");
  EXPECT_THAT(changes[0]["difference"].get<std::string>(), HasSubstr("time > 30 s"));
  EXPECT_EQ(changes[2]["difference"], changes[0]["difference"]);
}

TEST_F(WriteReportTest, TellsWhatRemainsInOtherProfiles) {
  WriteTunedRun(folder());
  const json data = Data();
  ASSERT_THAT(data["evaluations"], SizeIs(1));
  const json& evaluation = data["evaluations"][0];
  EXPECT_EQ(evaluation["profile"], "paper-tree");
  EXPECT_EQ(evaluation["checkpoint_episode"], 400);
  EXPECT_EQ(evaluation["return"]["count"], 3);
  EXPECT_EQ(evaluation["return"]["mean"], 10);
  EXPECT_NEAR(evaluation["return"]["high"].get<double>(), 10 + 4.3027 / std::sqrt(3), 1e-3);
  EXPECT_EQ(evaluation["learned_return"], 12.5);
  EXPECT_DOUBLE_EQ(evaluation["share"], 0.8);
  EXPECT_EQ(evaluation["ends"], (json{{"failure", 1}, {"truncated", 2}}));
}

TEST_F(WriteReportTest, ADamagedEvaluationCostsOnlyItself) {
  WriteTunedRun(folder());
  std::ofstream(folder() / "evaluation-fast.json") << "{";
  const json data = Data();
  EXPECT_THAT(data["evaluations"], SizeIs(1));
  EXPECT_THAT(data["notes"], ElementsAre(HasSubstr("evaluation-fast.json")));
}

TEST_F(WriteReportTest, CountsTheEndsByKindAndReason) {
  RunDatabase database = Create();
  EpisodeRecord fall = Episode(2, 0);
  fall.active.end_kind = "failure";
  fall.active.end_reason = "falls";
  database.AddEpisode(Episode(1, 0), std::nullopt, std::nullopt);
  database.AddEpisode(fall, std::nullopt, std::nullopt);
  database.AddEpisode(Episode(3, 0), std::nullopt, std::nullopt);
  const json data = Data();
  EXPECT_EQ(data["ends"], (json{{{"kind", "truncated"}, {"reason", "time is up"}, {"count", 2}},
                                {{"kind", "failure"}, {"reason", "falls"}, {"count", 1}}}));
  EXPECT_EQ(data["endOf"], (json{0, 1, 0}));
  EXPECT_EQ(data["simulatedSeconds"], 60);
  EXPECT_EQ(data["wallSeconds"], 6);
}

TEST_F(WriteReportTest, TellsWhereTheRunComesFrom) {
  RunDatabase database = Create();
  database.AddEpisode(Episode(1, 0), std::nullopt, std::nullopt);
  const json data = Data();
  EXPECT_EQ(data["run"]["task"], "crawling");
  EXPECT_EQ(data["run"]["seed"], "1");
  EXPECT_EQ(data["settings"][0]["name"], "task.fall_penalty");
  EXPECT_EQ(data["settings"][0]["value"], "8.0");
  EXPECT_EQ(data["command"],
            "trainer train tasks/crawling.task --set task.fall_penalty=8 --profile paper "
            "--episodes 2000 --seed 1");
  EXPECT_EQ(data["run"]["state"], "running");
  ASSERT_THAT(data["tasks"], SizeIs(1));
  const json& sources = data["tasks"][0]["sources"];
  ASSERT_THAT(sources, SizeIs(2));
  EXPECT_EQ(sources[0]["text"], run_.tasks[0].sources[0].text);
  EXPECT_EQ(sources[1]["file"], "tasks/shaping.task");
  EXPECT_EQ(data["versions"], (json{{{"task", 0}, {"first", 1}, {"last", 1}}}));
  EXPECT_THAT(data["shadows"], IsEmpty());
  EXPECT_THAT(data["changes"], IsEmpty());
  EXPECT_EQ(data["agentText"], run_.agent);
  EXPECT_EQ(data["modules"]["learner"]["type"], "PengQLambda");
  EXPECT_EQ(data["modules"]["learner"]["temperature"], 5.0);
}

TEST_F(WriteReportTest, AnAgentThatIsNoTomlIsStillShown) {
  run_.agent = "= broken";
  RunDatabase database = Create();
  database.AddEpisode(Episode(1, 0), std::nullopt, std::nullopt);
  const json data = Data();
  EXPECT_EQ(data["agentText"], "= broken");
  EXPECT_THAT(data["modules"], IsEmpty());
}

TEST_F(WriteReportTest, CarriesTheRecordedPosesAndMarksTheBest) {
  RunDatabase database = Create();
  database.AddEpisode(Episode(1, 7), TwoLinks(Frames(3)), std::nullopt);
  database.AddEpisode(Episode(2, 5), TwoLinks(Frames(1)), std::nullopt);
  database.AddEpisode(Episode(3, 9), std::nullopt, std::nullopt);
  const json data = Data();
  ASSERT_THAT(data["recordings"], SizeIs(2));
  const json& first = data["recordings"][0];
  EXPECT_EQ(first["episode"], 1);
  EXPECT_EQ(first["best"], true);
  EXPECT_EQ(first["frames"], 3);
  EXPECT_EQ(first["interval"], 0.02);
  EXPECT_EQ(Floats(first["poses"]), Frames(3));
  EXPECT_EQ(data["recordings"][1]["best"], false);
  EXPECT_EQ(data["body"][1]["name"], "foot");
  EXPECT_THAT(data["notes"], IsEmpty());
}

// Of three frames, and of SampleCrawling().
Timeline SmallTimeline() {
  return {.end = 0.055,
          .returns = {0, 1, 2, -4},
          .terms = {{0, 1, 2, 0}, {0, 0, 0, 0}, {0, 0, 0, -4}},
          .metrics = {{kNan, 0.1f, 0.2f, 0.3f}, {kNan, 0, 0, 1}},
          .phases = {},
          .contacts = {0, 1, 3, 2}};
}

TEST_F(WriteReportTest, CarriesWhatEachStepPaid) {
  Recording recording = TwoLinks(Frames(3));
  recording.timeline = PackTimeline(SmallTimeline());
  RunDatabase database = Create();
  database.AddEpisode(Episode(1, 7), recording, std::nullopt);
  const json shown = Data()["recordings"][0];
  EXPECT_EQ(shown["task"], 0);
  EXPECT_EQ(shown["end"]["kind"], Episode(1, 7).active.end_kind);
  const json& timeline = shown["timeline"];
  EXPECT_EQ(timeline["end"], 0.055);
  EXPECT_THAT(Floats(timeline["returns"]), ElementsAre(0, 1, 2, -4));
  ASSERT_THAT(timeline["terms"], SizeIs(3));
  EXPECT_EQ(timeline["terms"][2]["name"], "fall");
  EXPECT_THAT(Floats(timeline["terms"][2]["values"]), ElementsAre(0, 0, 0, -4));
  EXPECT_EQ(timeline["metrics"][0]["unit"], "m");
  EXPECT_EQ(timeline["metrics"][1]["reduction"], "sum");
  EXPECT_EQ(timeline["contacts"], "AAEDAg==");
  EXPECT_FALSE(timeline.contains("phases"));
}

TEST_F(WriteReportTest, ATimelineLosesTheSamplesOfFramesThatAreLeftOut) {
  std::vector<float> poses = Frames(3);
  poses[2 * 14 + 5] = kNan;
  Recording recording = TwoLinks(poses);
  recording.timeline = PackTimeline(SmallTimeline());
  RunDatabase database = Create();
  database.AddEpisode(Episode(1, 7), recording, std::nullopt);
  const json timeline = Data()["recordings"][0]["timeline"];
  EXPECT_THAT(Floats(timeline["returns"]), ElementsAre(0, 1, -4));
  EXPECT_EQ(timeline["contacts"], "AAEC");
}

TEST_F(WriteReportTest, ADamagedTimelineCostsOnlyItself) {
  Recording damaged = TwoLinks(Frames(3));
  damaged.timeline = "no timeline";
  RunDatabase database = Create();
  database.AddEpisode(Episode(1, 7), damaged, std::nullopt);
  database.AddEpisode(Episode(2, 7), TwoLinks(Frames(3)), std::nullopt);
  const json data = Data();
  ASSERT_THAT(data["recordings"], SizeIs(2));
  EXPECT_TRUE(data["recordings"][0]["timeline"].is_null());
  EXPECT_TRUE(data["recordings"][1]["timeline"].is_null());
  EXPECT_THAT(data["notes"],
              ElementsAre(HasSubstr("What episode 1 paid from step to step is left out: ")));
}

TEST_F(WriteReportTest, ARecordingEndsWhereItsPosesAreNoLongerFinite) {
  std::vector<float> poses = Frames(3);
  poses[2 * 14 + 5] = kNan;
  RunDatabase database = Create();
  database.AddEpisode(Episode(1, 7), TwoLinks(poses), std::nullopt);
  const json recording = Data()["recordings"][0];
  EXPECT_EQ(recording["frames"], 2);
  EXPECT_EQ(Floats(recording["poses"]), Frames(2));
}

TEST_F(WriteReportTest, ADamagedRecordingCostsOnlyItself) {
  Recording cut = TwoLinks(Frames(3));
  cut.poses.resize(cut.poses.size() / 2);
  Recording other_robot = TwoLinks(Frames(3));
  other_robot.frames = 4;
  RunDatabase database = Create();
  database.AddEpisode(Episode(1, 9), cut, std::nullopt);
  database.AddEpisode(Episode(2, 8), other_robot, std::nullopt);
  database.AddEpisode(Episode(3, 7), TwoLinks(Frames(1)), std::nullopt);
  const json data = Data();
  ASSERT_THAT(data["recordings"], SizeIs(1));
  EXPECT_EQ(data["recordings"][0]["episode"], 3);
  EXPECT_THAT(data["notes"], ElementsAre(HasSubstr("episode 1"), HasSubstr("episode 2")));
}

TEST_F(WriteReportTest, SaysHowManyRecordingsDidNotFit) {
  RunDatabase database = Create();
  for (int64_t number = 1; number <= 50; ++number) {
    database.AddEpisode(Episode(number, 0), TwoLinks(Frames(1)), std::nullopt);
  }
  const json data = Data();
  EXPECT_THAT(data["recordings"], SizeIs(40));
  EXPECT_THAT(data["notes"], ElementsAre(HasSubstr("40 of 50 recorded episodes")));
}

TEST_F(WriteReportTest, ARunWithoutShapesHasNoReplay) {
  run_.body = "[]";
  RunDatabase database = Create();
  database.AddEpisode(Episode(1, 0), TwoLinks(Frames(1)), std::nullopt);
  const json data = Data();
  EXPECT_THAT(data["recordings"], IsEmpty());
  EXPECT_THAT(data["notes"], ElementsAre(HasSubstr("shapes")));
}

TEST_F(WriteReportTest, ThePageAsksForNothingFromElsewhere) {
  WriteSampleRun(folder(), {.episodes = 3, .record_every = 1});
  const std::string page = ReadText(WriteReport(folder()));
  EXPECT_THAT(page,
              HasSubstr("http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'"));
  const std::regex loads(
      R"((src|href|action|data)\s*=\s*["']?(https?:)?//|@import|url\(["']?(https?:)?//)",
      std::regex::optimize);
  const size_t begin = page.find("<script id=\"report-data\"");
  const size_t end = page.find("</script>", begin);
  const std::string markup = page.substr(0, begin);
  EXPECT_FALSE(std::regex_search(markup, loads));
  EXPECT_FALSE(
      std::regex_search(page.begin() + static_cast<std::ptrdiff_t>(end), page.end(), loads));
}

TEST_F(WriteReportTest, GoesWhereItIsTold) {
  WriteSampleRun(folder(), {.episodes = 1});
  const std::filesystem::path output = folder_.path() / "page.html";
  EXPECT_EQ(WriteReport(folder(), output), output);
  EXPECT_TRUE(std::filesystem::exists(output));
  EXPECT_FALSE(std::filesystem::exists(folder() / "report.html"));
  EXPECT_EQ(WriteReport(folder()), folder() / "report.html");
}

TEST_F(WriteReportTest, AnUnknownFolderIsNamedWithTheRemedy) {
  WriteSampleRun(folder(), {.episodes = 1});
  const std::filesystem::path output = folder_.path() / "nowhere" / "page.html";
  const std::string error = ErrorOf([&] { WriteReport(folder(), output); });
  EXPECT_THAT(error, HasSubstr(output.string()));
  EXPECT_THAT(error, HasSubstr("--output"));
}

TEST_F(WriteReportTest, AFileThatCannotGrowLeavesTheOlderReport) {
  WriteSampleRun(folder(), {.episodes = 1});
  std::ofstream(folder() / "report.html") << "older";
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  // Enough for the index that SQLite keeps beside the database, too little for the page.
  const rlimit small{100000, before.rlim_max};
  const auto handler = signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string error = ErrorOf([&] { WriteReport(folder()); });
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, handler);
  EXPECT_THAT(error, HasSubstr("cannot write the report: File too large"));
  EXPECT_EQ(ReadText(folder() / "report.html"), "older");
  for (const auto& file : std::filesystem::directory_iterator(folder())) {
    EXPECT_NE(file.path().extension(), ".part");
  }
}

TEST_F(WriteReportTest, AFolderWithoutARunIsNamed) {
  const std::string error = ErrorOf([&] { WriteReport(folder()); });
  EXPECT_THAT(error, HasSubstr(folder().string()));
  EXPECT_THAT(error, HasSubstr("no run"));
}

TEST_F(WriteReportTest, ARunWithoutAnEpisodeSaysToWait) {
  const RunDatabase database = Create();
  EXPECT_THAT(ErrorOf([&] { WriteReport(folder()); }), HasSubstr("no finished episode yet; wait"));
}

TEST_F(WriteReportTest, ADamagedDatabaseIsNamed) {
  std::filesystem::create_directories(folder());
  std::ofstream(folder() / "run.db") << std::string(4096, 'x');
  const std::string error = ErrorOf([&] { WriteReport(folder()); });
  EXPECT_THAT(error, HasSubstr("run.db"));
  EXPECT_THAT(error, HasSubstr("damaged"));
}

}  // namespace
}  // namespace runtime
