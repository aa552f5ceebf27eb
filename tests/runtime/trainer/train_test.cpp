#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

#include "runtime/training/run/compression.h"
#include "runtime/training/run/timeline.h"
#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class TrainTest : public TrainerTest {};

TEST_F(TrainTest, StoresWhatTheRunIs) {
  Train("run", 2, {"--seed", "7", "--set", "learner.temperature=2.5", "--quiet"});
  const RunDatabase database = RunDatabase::OpenToRead(RunFolder("run"));
  const RunRecord run = database.ReadRun();
  ASSERT_EQ(run.tasks.size(), 1u);
  const TaskRecord& task = run.tasks.front();
  EXPECT_EQ(task.id, 1);
  EXPECT_EQ(task.module, "task");
  EXPECT_EQ(task.task, "leaning");
  EXPECT_THAT(task.sources.front().text, HasSubstr("task leaning for humanoid"));
  EXPECT_EQ(task.task_hash.size(), 64u);
  EXPECT_EQ(run.robot, "humanoid");
  EXPECT_THAT(run.robot_description, HasSubstr("left_foot"));
  EXPECT_EQ(run.profile, "fast");
  EXPECT_EQ(run.seed, 7u);
  EXPECT_EQ(run.episodes_planned, 2);
  EXPECT_THAT(run.agent, HasSubstr("temperature = 2.5"));
  EXPECT_EQ(nlohmann::json::parse(run.body).size(), 18u);
  ASSERT_EQ(task.terms.size(), 2u);
  EXPECT_EQ(task.terms[0].name, "forward");
  ASSERT_EQ(task.metrics.size(), 2u);
  EXPECT_EQ(task.metrics[0].reduction, "max");
  EXPECT_EQ(task.metrics[1].unit, "m/s");
  ASSERT_EQ(task.logs.size(), 2u);
  EXPECT_EQ(task.logs[0].name, "height");
  EXPECT_EQ(task.logs[0].reduction, "max");
  EXPECT_EQ(database.ReadState(), RunState::kFinished);
}

TEST_F(TrainTest, StoresEveryEpisode) {
  Train("run", 3, {"--quiet"});
  const std::vector<EpisodeRecord> episodes =
      RunDatabase::OpenToRead(RunFolder("run")).ReadEpisodes();
  ASSERT_EQ(episodes.size(), 3u);
  for (const EpisodeRecord& episode : episodes) {
    ASSERT_EQ(episode.active.terms.size(), 2u);
    ASSERT_EQ(episode.active.metrics.size(), 2u);
    ASSERT_EQ(episode.active.logs.size(), 2u);
    EXPECT_GT(episode.active.logs[0], 0.1);  // the body of one that stands
    EXPECT_NEAR(episode.active.terms[0] + episode.active.terms[1], episode.active.episode_return,
                1e-12);
    EXPECT_NEAR(episode.simulated_seconds, 0.005 * static_cast<double>(episode.steps), 1e-9);
    EXPECT_GT(episode.actions, 0);
    EXPECT_GT(episode.wall_seconds, 0);
    EXPECT_GT(episode.cpu_seconds, 0);
    EXPECT_EQ(episode.active.faults, 0);
  }
  EXPECT_EQ(episodes[0].active.end_reason, "time is up");
  EXPECT_EQ(episodes[0].active.end_kind, "truncated");
}

TEST_F(TrainTest, RecordsTheBestEpisodesEveryNthAndTheLast) {
  Train("run", 4, {"--record-every", "3", "--quiet"});
  const RunDatabase database = RunDatabase::OpenToRead(RunFolder("run"));
  double best = -1e300;
  for (const EpisodeRecord& episode : database.ReadEpisodes()) {
    const bool is_best = episode.active.episode_return > best;
    best = std::max(best, episode.active.episode_return);
    const std::optional<Recording> recording = database.ReadRecording(episode.number);
    ASSERT_EQ(recording.has_value(), is_best || episode.number >= 3) << episode.number;
    if (!recording) continue;
    EXPECT_EQ(recording->is_best, is_best);
    EXPECT_EQ(recording->frame_interval, 0.02);
    EXPECT_EQ(recording->frames, episode.steps / 4 + 1);
    EXPECT_EQ(Decompress(recording->poses, "poses").size(),
              static_cast<size_t>(recording->frames) * 18 * 7 * sizeof(float));
  }
}

// What the samples say adds up to what the episode's own record says.
TEST_F(TrainTest, RecordsWhatEachStepPaid) {
  Train("run", 2, {"--record-every", "1", "--quiet"});
  const RunDatabase database = RunDatabase::OpenToRead(RunFolder("run"));
  const RunRecord run = database.ReadRun();
  const TaskRecord& task = run.tasks.front();
  for (const EpisodeRecord& episode : database.ReadEpisodes()) {
    const Recording recording = *database.ReadRecording(episode.number);
    const Timeline timeline = ReadTimeline(recording, task, 18);
    EXPECT_EQ(timeline.sample_count(), static_cast<size_t>(recording.frames) + 1);
    EXPECT_EQ(timeline.end, episode.simulated_seconds);
    const auto sum = [](const std::vector<float>& paid) {
      return std::accumulate(paid.begin(), paid.end(), 0.0);
    };
    EXPECT_NEAR(sum(timeline.returns), episode.active.episode_return, 1e-5);
    for (size_t i = 0; i < task.terms.size(); ++i) {
      EXPECT_NEAR(sum(timeline.terms[i]), episode.active.terms[i], 1e-5) << task.terms[i].name;
    }
    for (size_t i = 0; i < task.metrics.size(); ++i) {
      EXPECT_TRUE(std::isnan(timeline.metrics[i].front()));
      const std::string& reduction = task.metrics[i].reduction;
      if (reduction != "last" && reduction != "sum") continue;
      EXPECT_FLOAT_EQ(timeline.metrics[i].back(), static_cast<float>(episode.active.metrics[i]));
    }
    EXPECT_TRUE(std::ranges::any_of(timeline.contacts, [](uint8_t byte) { return byte != 0; }));
    EXPECT_LT(recording.timeline.size(), recording.poses.size() / 5);
  }
}

TEST_F(TrainTest, RunsAreEqualForEqualSeedsOnly) {
  Train("one", 4, {"--seed", "1", "--quiet"});
  Train("two", 4, {"--seed", "1", "--quiet"});
  Train("three", 4, {"--seed", "2", "--quiet"});
  ExpectEqual(TraceOf("one"), TraceOf("two"));
  EXPECT_NE(TraceOf("one").episodes, TraceOf("three").episodes);
}

TEST_F(TrainTest, TakesAPluginThatIsBuiltAlready) {
  const std::filesystem::path compiler = std::filesystem::path(TRAINER).parent_path() / "taskc";
  const std::string plugin = (folder() / "leaning.so").string();
  const ProgramResult built =
      RunProgram({compiler.string(), "build", TaskFile("leaning"), "-o", plugin});
  ASSERT_EQ(built.exit_status, 0) << built.errors;
  const ProgramResult result = Trainer({"train", plugin, "--profile", "fast", "--episodes", "2",
                                        "--quiet", "--out", RunFolder("plugin")});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  Train("source", 2, {"--quiet"});
  ExpectEqual(TraceOf("plugin"), TraceOf("source"));
}

TEST_F(TrainTest, TakesTheAgentsFilesInTheirOrder) {
  std::filesystem::copy_file(TaskFile("leaning"), folder() / "leaning.task");
  std::ofstream(folder() / "leaning.agent.toml")
      << "[modules.learner]\ntemperature = 1.5\ndiscount = 0.5\n";
  std::ofstream(folder() / "more.toml") << "[modules.learner]\ndiscount = 0.25\n";
  const ProgramResult result = Trainer(
      {"train", (folder() / "leaning.task").string(), "--profile", "fast", "--episodes", "1",
       "--agent", (folder() / "more.toml").string(), "--quiet", "--out", RunFolder("run")});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  const std::string agent = RunDatabase::OpenToRead(RunFolder("run")).ReadRun().agent;
  EXPECT_THAT(agent, AllOf(HasSubstr("temperature = 1.5"), HasSubstr("discount = 0.25")));
}

TEST_F(TrainTest, PrintsOneJsonObjectPerEpisode) {
  const ProgramResult result = Trainer(Training("run", 2, {"--json"}));
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  std::istringstream lines(result.output);
  int episodes = 0;
  for (std::string line; std::getline(lines, line);) {
    const nlohmann::json shown = nlohmann::json::parse(line);
    EXPECT_EQ(shown["episode"], ++episodes);
    EXPECT_TRUE(shown["terms"].contains("forward"));
    EXPECT_TRUE(shown["metrics"].contains("leaning"));
    EXPECT_TRUE(shown["logs"]["height"].is_number());
  }
  EXPECT_EQ(episodes, 2);
}

TEST_F(TrainTest, PrintsPlainTextIntoAPipe) {
  const ProgramResult result = Trainer(Training("run", 2));
  EXPECT_THAT(result.output, AllOf(HasSubstr("episode 2/2"), HasSubstr("trainer report")));
  EXPECT_EQ(result.output.find_first_of("\r\x1b"), std::string::npos);
}

TEST_F(TrainTest, TruncatesAndCountsEpisodesThatViolateARequirement) {
  const ProgramResult result = Trainer({"train", TaskFile("demanding"), "--profile", "fast",
                                        "--episodes", "3", "--quiet", "--out", RunFolder("run")});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  for (const EpisodeRecord& episode : RunDatabase::OpenToRead(RunFolder("run")).ReadEpisodes()) {
    EXPECT_EQ(episode.active.end_kind, "truncated");
    EXPECT_EQ(episode.active.end_reason, "requirement: it is early");
    EXPECT_GT(episode.active.violations, 0);
  }
  // One warning in the whole run.
  EXPECT_THAT(result.errors,
              AllOf(testing::StartsWith("warning: episode 1: demanding requires `it is early` ("),
                    HasSubstr("demanding.task:7)"), HasSubstr(" s; such episodes")));
  EXPECT_EQ(result.errors.find("it is early"), result.errors.rfind("it is early"));
}

TEST_F(TrainTest, ShowsLogsAndViolations) {
  const ProgramResult trained = Trainer({"train", TaskFile("demanding"), "--profile", "fast",
                                         "--episodes", "1", "--quiet", "--out", RunFolder("run")});
  ASSERT_EQ(trained.exit_status, 0) << trained.errors;
  const ProgramResult text = Trainer({"show", RunFolder("run")});
  EXPECT_THAT(text.output,
              AllOf(HasSubstr("log        height: 0."), HasSubstr("log        late: "),
                    HasSubstr("violations "), HasSubstr("1 truncated: requirement: it is early")));
  const nlohmann::json shown =
      nlohmann::json::parse(Trainer({"show", RunFolder("run"), "--json"}).output);
  EXPECT_GT(shown["logs"]["height"].get<double>(), 0.1);
  EXPECT_GT(shown["violations"].get<int>(), 0);
}

TEST_F(TrainTest, SaysWhatWouldFillASensorThatNoRobotHas) {
  std::ofstream(folder() / "foreign.task")
      << "task foreign\nsensor wind: real [m/s]\non end_of_time_step {\n"
         "  if wind > 3 m/s { truncate_episode \"stormy\" }\n}\n";
  const std::string task = (folder() / "foreign.task").string();
  const ProgramResult result =
      Trainer({"train", task, "--robot", "humanoid", "--quiet", "--out", RunFolder("run")});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(
      result.errors,
      HasSubstr("the task `foreign` reads the sensor `wind`, and no module has an out port"));
  EXPECT_EQ(result.errors.find("task.so"), std::string::npos) << result.errors;
}

TEST_F(TrainTest, SaysNothingWhenQuiet) {
  const ProgramResult result = Trainer(Training("run", 1, {"--quiet"}));
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(result.errors, "");
}

TEST_F(TrainTest, NamesTheFolderAfterTaskProfileAndSeed) {
  const std::string here = std::filesystem::current_path().string();
  std::filesystem::current_path(folder());
  const ProgramResult result = Trainer({"train", TaskFile("leaning"), "--profile", "fast",
                                        "--episodes", "1", "--seed", "5", "--quiet"});
  std::filesystem::current_path(here);
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_TRUE(RunDatabase::Exists(folder() / "runs" / "leaning-fast-seed5"));
}

TEST_F(TrainTest, PassesTheCompilersMessagesThrough) {
  const ProgramResult result =
      Trainer({"train", TaskFile("wrong"), "--out", RunFolder("run"), "--quiet"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, AllOf(HasSubstr("wrong.task:5:"), HasSubstr("velocty")));
  EXPECT_FALSE(std::filesystem::exists(RunFolder("run")));
}

TEST_F(TrainTest, RefusesATaskWithoutAnEnd) {
  const ProgramResult result =
      Trainer({"train", TaskFile("endless"), "--out", RunFolder("run"), "--quiet"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("truncate_episode"));
  EXPECT_FALSE(std::filesystem::exists(RunFolder("run")));
}

TEST_F(TrainTest, RefusesAnAgentWithTwoTaskModules) {
  const std::string agent = (folder() / "two.toml").string();
  std::ofstream(agent) << "[modules.second]\ntype = \"UniversalTask\"\n";
  const ProgramResult result = Trainer(Training("run", 1, {"--agent", agent}));
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("two task modules, `task` and `second`"));
}

TEST_F(TrainTest, RefusesAnAgentThatCannotLearnBeforeItMakesTheFolder) {
  const std::string agent = (folder() / "agent.toml").string();
  const auto refusal = [&](const std::string& text) {
    std::ofstream(agent) << text;
    const ProgramResult result = Trainer(Training("run", 1, {"--agent", agent}));
    EXPECT_EQ(result.exit_status, 1);
    EXPECT_FALSE(std::filesystem::exists(RunFolder("run")));
    return result.errors;
  };
  EXPECT_THAT(refusal("[modules.second]\ntype = \"PengQLambda\"\n"),
              HasSubstr("the agent has two learners, `learner` and `second`: keep one"));
  EXPECT_THAT(refusal("[modules.second]\ntype = \"RobotEnvironment\"\n"),
              HasSubstr("the agent has two environments, `environment` and `second`: keep one"));
  const std::string world = "whole = true\n[modules.world]\ntype = \"RobotEnvironment\"\n";
  const std::string task = "[modules.task]\ntype = \"UniversalTask\"\n";
  EXPECT_THAT(refusal(world + task), HasSubstr("the agent has no learner: "));
  EXPECT_THAT(refusal(world + task + "[modules.mind]\ntype = \"PengQLambda\"\n"),
              HasSubstr("no task pays the learner: connect the `reward` of a task module to "
                        "`mind.reward`"));
  EXPECT_THAT(refusal("whole = true\n" + task),
              HasSubstr("the agent has no module of the type `RobotEnvironment`"));
}

TEST_F(TrainTest, RefusesAFolderThatHoldsARun) {
  Train("run", 1, {"--quiet"});
  const Trace before = TraceOf("run");
  const ProgramResult result = Trainer(Training("run", 5, {"--quiet"}));
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, AllOf(HasSubstr("trainer resume"), HasSubstr(RunFolder("run"))));
  ExpectEqual(before, TraceOf("run"));
}

}  // namespace
}  // namespace runtime
