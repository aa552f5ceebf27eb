#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/runtime/trainer/trainer_test.h"
#include "tests/runtime/training/run/sample_run.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class ShowTest : public TrainerTest {
 protected:
  // Two episodes; the first task was swapped for another before the second, and is its shadow.
  void WriteTunedRun() const {
    RunDatabase database = RunDatabase::Create(RunFolder("run"), SampleRun());
    database.AddTask(SampleVersion());
    database.AddChange({0, 2, 0, "2026-01-02T03:04:05Z", SwapTask{"task", 1}, "swap task: b.task"});
    database.AddChange({0, 2, 40, "2026-01-02T03:04:06Z", SetParameter{"task.gain", int64_t{2}},
                        "set task.gain = 2"});
    EpisodeRecord second = SampleEpisode(2);
    second.shadows = {second.active};
    second.active = SampleShadow();
    database.AddEpisode(SampleEpisode(1), {}, {});
    database.AddEpisode(second, {}, {});
  }
};

TEST_F(ShowTest, TellsChangesVersionsAndShadows) {
  WriteTunedRun();
  const std::string output = Trainer({"show", RunFolder("run")}).output;
  EXPECT_THAT(output, AllOf(HasSubstr("version    episodes 1 to 1: crawling (0123abcd)\n"),
                            HasSubstr("version    episodes 2 to 2: crawling (4567cdef)\n"),
                            HasSubstr("shadow     task, crawling (0123abcd): 0.2 on average"),
                            HasSubstr("change     episode 2: swap task: b.task\n"),
                            HasSubstr("change     episode 2, step 40: set task.gain = 2\n")));
  EXPECT_THAT(output, HasSubstr("distance: 0.75 m on average"));  // of the active task's episode
  const auto shown = nlohmann::json::parse(Trainer({"show", RunFolder("run"), "--json"}).output);
  EXPECT_EQ(shown["versions"].size(), 2u);
  EXPECT_EQ(shown["versions"][1]["first_episode"], 2);
  EXPECT_EQ(shown["shadows"]["task"]["last_return"], 0.2);
  EXPECT_EQ(shown["changes"][1]["step"], 40);
}

// From the texts that the run keeps: there are no such files.
TEST_F(ShowTest, SaysWhatAVersionChanged) {
  const std::string text =
      "task a for humanoid\non end_of_time_step {\n  reward rate up = base.position.z / 1 m\n"
      "  if time > 1 s { truncate_episode \"time is up\" }\n}\n";
  std::string changed = text;
  changed.replace(changed.find("1 s"), 3, "2 s");
  RunRecord run = SampleRun();
  run.robot = "humanoid";
  std::ifstream robot(ROBOTS "/humanoid/robot.toml");
  run.robot_description = std::string{std::istreambuf_iterator<char>(robot), {}};
  run.tasks.front().sources = {{"gone/a.task", text}};
  TaskRecord version = SampleVersion();
  version.sources = {{"gone/a.task", changed}};
  RunDatabase database = RunDatabase::Create(RunFolder("run"), run);
  database.AddTask(version);
  EpisodeRecord second = SampleEpisode(2);
  second.shadows = {second.active};
  second.active = SampleShadow();
  database.AddEpisode(SampleEpisode(1), {}, {});
  database.AddEpisode(second, {}, {});
  EXPECT_THAT(Trainer({"show", RunFolder("run")}).output,
              AllOf(HasSubstr("  end truncation \"time is up\": when\n"),
                    HasSubstr("    + end_of_time_step: if time > 2 s: ends\n")));
  const auto shown = nlohmann::json::parse(Trainer({"show", RunFolder("run"), "--json"}).output);
  EXPECT_EQ(shown["versions"][0]["difference"], "");
  EXPECT_THAT(shown["versions"][1]["difference"].get<std::string>(), HasSubstr("time > 2 s"));
}

TEST_F(ShowTest, TellsWhatTheLearnerShowedLast) {
  {
    RunDatabase database = RunDatabase::Create(RunFolder("run"), SampleRun());
    database.SetLearnerCurves({{"rate", "", "", ""}});
    for (int64_t number = 1; number <= 2; ++number) {
      EpisodeRecord episode = SampleEpisode(number);
      episode.learner = {{"rate", 0.5 / static_cast<double>(number)}};
      database.AddEpisode(episode, {}, {});
    }
  }
  EXPECT_THAT(Trainer({"show", RunFolder("run")}).output,
              HasSubstr("learner    rate: 0.25 in the last episode\n"));
  const auto shown = nlohmann::json::parse(Trainer({"show", RunFolder("run"), "--json"}).output);
  EXPECT_EQ(shown["learner"], (nlohmann::json{{"rate", 0.25}}));
}

TEST_F(ShowTest, TellsWhatTheRobotWasToldLast) {
  {
    RunRecord run = SampleRun();
    run.tasks[0].goals = {{"side", "int", "", ""}, {"place", "vec2", "m", "where to go"}};
    RunDatabase database = RunDatabase::Create(RunFolder("run"), run);
    EpisodeRecord episode = SampleEpisode(1);
    episode.active.goals = {{0, 0, {-1}}, {1, 0, {1, 2}}, {1, 0.5, {0.25, -2}}};
    database.AddEpisode(episode, {}, {});
  }
  EXPECT_THAT(Trainer({"show", RunFolder("run")}).output,
              AllOf(HasSubstr("goal       side: -1 at the end of the last episode\n"),
                    HasSubstr("goal       place: 0.25, -2 m at the end of the last episode\n")));
  const auto shown = nlohmann::json::parse(Trainer({"show", RunFolder("run"), "--json"}).output);
  EXPECT_EQ(shown["goals"], (nlohmann::json{{"place", {0.25, -2.0}}, {"side", {-1.0}}}));
}

TEST_F(ShowTest, TellsWhatWasSetAndHowToMakeTheRunAgain) {
  const std::string agent = (folder() / "warm.toml").string();
  std::ofstream(agent) << "[modules.learner]\ntemperature = 3\ntrace_max = 1\n";
  Train("run", 1,
        {"--quiet", "--seed", "4", "--agent", agent, "--set", "task.limit=0.1", "--set",
         "learner.temperature=2", "--record-every", "0"});
  const std::string output = Trainer({"show", RunFolder("run")}).output;
  EXPECT_THAT(output, AllOf(HasSubstr("setting    task.limit = 0.1 (--set)\n"),
                            HasSubstr("setting    learner.temperature = 2.0 (--set)\n"),
                            HasSubstr("setting    learner.trace_max = 1.0 (" + agent + ":3:1)\n"),
                            Not(HasSubstr("3.0"))));
  const auto shown = nlohmann::json::parse(Trainer({"show", RunFolder("run"), "--json"}).output);
  EXPECT_EQ(shown["settings"].size(), 3u);
  const std::string command = shown["command"];
  EXPECT_THAT(output, HasSubstr("command    " + command + "\n"));
  ASSERT_THAT(command, testing::StartsWith("trainer train "));
  std::istringstream stream(command.substr(8) + " --quiet --out " + RunFolder("again"));
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  EXPECT_EQ(Trainer(words).exit_status, 0);
  ExpectEqual(TraceOf("run"), TraceOf("again"));
  EXPECT_EQ(RunDatabase::OpenToRead(RunFolder("again")).ReadRun().agent,
            RunDatabase::OpenToRead(RunFolder("run")).ReadRun().agent);
}

TEST_F(ShowTest, SaysWhatResumeRepeats) {
  {
    RunDatabase database = RunDatabase::Create(RunFolder("run"), SampleRun());
    for (int64_t number : {1, 2}) database.AddEpisode(SampleEpisode(number), {}, {});
  }
  EXPECT_THAT(Trainer({"show", RunFolder("run")}).output,
              HasSubstr("episodes   2 of 1000 recorded; there is no checkpoint yet: `resume` "
                        "repeats 2 episodes\n"));
  RunDatabase::Open(RunFolder("run")).WriteCheckpoint({1, "state"});
  EXPECT_THAT(Trainer({"show", RunFolder("run")}).output,
              HasSubstr("the last checkpoint is at 1: `resume` repeats 1 episode\n"));
  RunDatabase::Open(RunFolder("run")).WriteCheckpoint({2, "state"});
  EXPECT_THAT(Trainer({"show", RunFolder("run")}).output, HasSubstr("episodes   2 of 1000\n"));
}

// A task's file and the ends of its episodes have names that anyone may have chosen.
TEST_F(ShowTest, SendsNoEscapeSequenceToATerminal) {
  RunRecord run = SampleRun();
  run.tasks.front().task_file = "a\x1b]0;title\x07.task";
  RunDatabase database = RunDatabase::Create(RunFolder("run"), run);
  EpisodeRecord episode = SampleEpisode(1);
  episode.active.end_reason = "fell\x1b[2J\u202eover";
  database.AddEpisode(episode, {}, {});
  const std::string output = Trainer({"show", RunFolder("run")}).output;
  EXPECT_THAT(output, HasSubstr("(a\\u001b]0;title\\u0007.task)\n"));
  EXPECT_THAT(output, HasSubstr("fell\\u001b[2J\\u202eover"));
  EXPECT_THAT(output, AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("\u202e"))));
  const std::string text = Trainer({"show", RunFolder("run"), "--json"}).output;
  EXPECT_THAT(text, AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("\u202e"))));
  const auto shown = nlohmann::json::parse(text);
  EXPECT_EQ(shown["task_file"], run.tasks.front().task_file);
  EXPECT_EQ(shown["ends"][0]["reason"], episode.active.end_reason);
  const ProgramResult refused = Trainer({"show", RunFolder("absent\x1b[31m")});
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("absent\\u001b[31m"), Not(HasSubstr("\x1b"))));
}

TEST_F(ShowTest, SaysNothingOfThemWhereThereAreNone) {
  RunDatabase::Create(RunFolder("run"), SampleRun()).AddEpisode(SampleEpisode(1), {}, {});
  const std::string output = Trainer({"show", RunFolder("run")}).output;
  EXPECT_THAT(output, AllOf(HasSubstr("task       crawling (tasks/crawling.task)\n"),
                            Not(HasSubstr("version")), Not(HasSubstr("shadow")),
                            Not(HasSubstr("change")), Not(HasSubstr("learner "))));
}

}  // namespace
}  // namespace runtime
