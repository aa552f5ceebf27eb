#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "runtime/training/run/run_files.h"
#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

class EvaluateTest : public TrainerTest {
 protected:
  ProgramResult Evaluate(const std::string& name, const std::string& profile,
                         std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"evaluate", RunFolder(name), "--profile", profile});
    return Trainer(std::move(more));
  }
  // What it writes to the run's folder.
  json EvaluationOf(const std::string& name, const std::string& profile,
                    std::vector<std::string> more = {}) const {
    const ProgramResult result = Evaluate(name, profile, std::move(more));
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return Read(name, profile);
  }
  std::filesystem::path File(const std::string& name, const std::string& profile) const {
    return RunFolder(name) + "/evaluation-" + profile + ".json";
  }
  json Read(const std::string& name, const std::string& profile) const {
    return json::parse(std::ifstream(File(name, profile)));
  }
  void Write(const std::string& name, const std::string& profile, const std::string& text) const {
    std::ofstream(File(name, profile)) << text;
  }
  std::string Failure(const std::string& name) const {
    const ProgramResult result = Evaluate(name, "fast");
    EXPECT_EQ(result.exit_status, 1);
    EXPECT_FALSE(std::filesystem::exists(File(name, "fast")));
    return result.errors;
  }
  std::vector<double> ReturnsOf(const std::string& name) const {
    std::vector<double> returns;
    for (const EpisodeRecord& episode : RunDatabase::OpenToRead(RunFolder(name)).ReadEpisodes()) {
      returns.push_back(episode.active.episode_return);
    }
    return returns;
  }

  static std::vector<json> Lines(const std::string& text) {
    std::vector<json> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(json::parse(line));
    return lines;
  }

  // Learns in the first episode only: exp(-1000) is 0.
  const std::vector<std::string> learns_once_ = {
      "--set", "learner.learning_rate_decay=1000", "--set",  "learner.learning_rate_min=0",
      "--set", "learner.temperature_decay=0",      "--quiet"};
};

// A run that learns nothing any more goes on exactly as its evaluation does: with the same weights,
// random numbers and memory of its task.
TEST_F(EvaluateTest, InItsOwnProfileItActsAsItsRunWouldGoOn) {
  Train("run", 3, learns_once_);
  const json evaluation = EvaluationOf("run", "fast", {"--episodes", "4"});
  ASSERT_EQ(Trainer({"resume", RunFolder("run"), "--episodes", "7", "--quiet"}).exit_status, 0);
  const std::vector<double> returns = ReturnsOf("run");
  EXPECT_EQ(evaluation["returns"], json(std::vector(returns.begin() + 3, returns.end())));
  EXPECT_NE(returns[4], returns[5]);  // it explores
}

TEST_F(EvaluateTest, AGreedyPolicyDoesInEachEpisodeWhatItDidInTheLast) {
  std::vector<std::string> words = {"train",      TaskFile("standing"),
                                    "--profile",  "fast",
                                    "--episodes", "3",
                                    "--out",      RunFolder("run"),
                                    "--set",      "learner.temperature=0"};
  words.insert(words.end(), learns_once_.begin(), learns_once_.end());
  ASSERT_EQ(Trainer(words).exit_status, 0);
  const json evaluation = EvaluationOf("run", "fast");
  const double last = ReturnsOf("run").back();
  EXPECT_EQ(evaluation["returns"], (json{last, last, last}));
  EXPECT_EQ(evaluation["learned_return"], last);  // the window of 3 episodes is 1
  EXPECT_DOUBLE_EQ(evaluation["share"], 1);
  EXPECT_DOUBLE_EQ(evaluation["learned_metrics"]["height"], evaluation["metrics"]["height"]);
}

TEST_F(EvaluateTest, LearnsNothingAndLeavesTheRunAsItIs) {
  Train("run", 10,
        {"--set", "learner.temperature=0.1", "--set", "learner.temperature_decay=0", "--quiet"});
  const std::string before = ReadText(RunFolder("run") + "/run.db");
  const json first = EvaluationOf("run", "fast", {"--episodes", "10"});
  std::filesystem::remove(File("run", "fast"));
  EXPECT_EQ(EvaluationOf("run", "fast", {"--episodes", "10"}), first);
  EXPECT_EQ(ReadText(RunFolder("run") + "/run.db"), before);
  // The run itself learns on, and so does something else soon.
  ASSERT_EQ(Trainer({"resume", RunFolder("run"), "--episodes", "20", "--quiet"}).exit_status, 0);
  const std::vector<double> returns = ReturnsOf("run");
  EXPECT_EQ(first["returns"][0], returns[10]);
  EXPECT_NE(first["returns"], json(std::vector(returns.begin() + 10, returns.end())));
}

TEST_F(EvaluateTest, TellsWhatCameOut) {
  Train("run", 40, {"--quiet"});
  const json evaluation = EvaluationOf("run", "fast", {"--episodes", "2"});
  EXPECT_EQ(evaluation["profile"], "fast");
  EXPECT_EQ(evaluation["learned_profile"], "fast");
  EXPECT_EQ(evaluation["episodes"], 2);
  EXPECT_EQ(evaluation["checkpoint_episode"], 40);
  const std::vector<double> returns = evaluation["returns"];
  EXPECT_DOUBLE_EQ(evaluation["return"], (returns[0] + returns[1]) / 2);
  const std::vector<double> learned = ReturnsOf("run");  // the window of 40 episodes is 2
  const double learned_return = (learned[38] + learned[39]) / 2;
  EXPECT_DOUBLE_EQ(evaluation["learned_return"], learned_return);
  if (learned_return > 0) {
    EXPECT_DOUBLE_EQ(evaluation["share"], (returns[0] + returns[1]) / 2 / learned_return);
  } else {
    EXPECT_EQ(evaluation["share"], nullptr);
  }
  int ends = 0;
  for (const json& count : evaluation["ends"]) ends += count.get<int>();
  EXPECT_EQ(ends, 2);
  EXPECT_TRUE(evaluation["metrics"].contains("leaning"));
}

TEST_F(EvaluateTest, AnotherProfileIsAnotherBodyInMotion) {
  Train("run", 2, {"--quiet"});
  const json own = EvaluationOf("run", "fast", {"--episodes", "1"});
  const json paper = EvaluationOf("run", "paper", {"--episodes", "1"});
  EXPECT_EQ(paper["learned_profile"], "fast");
  EXPECT_NE(paper["returns"], own["returns"]);
  EXPECT_EQ(paper["learned_return"], own["learned_return"]);
}

TEST_F(EvaluateTest, PrintsATableOrJson) {
  Train("run", 2, {"--quiet"});
  const ProgramResult text = Evaluate("run", "fast", {"--episodes", "2"});
  EXPECT_THAT(text.output,
              AllOf(HasSubstr("\nepisode 2/2 "), HasSubstr("\nrun         learned        fast"),
                    HasSubstr("\n  leaning")));
  std::filesystem::remove(File("run", "fast"));
  const std::vector<json> lines =
      Lines(Evaluate("run", "fast", {"--episodes", "2", "--json"}).output);
  ASSERT_THAT(lines, SizeIs(3));
  EXPECT_EQ(lines[1]["episode"], 2);
  EXPECT_EQ(lines[2], Read("run", "fast"));
}

TEST_F(EvaluateTest, RepeatsOnlyWhatHasChanged) {
  Train("run", 2, {"--quiet"});
  json marked = EvaluationOf("run", "fast", {"--episodes", "1"});
  marked["return"] = 12345;
  const auto is_repeated = [&](std::vector<std::string> more) {
    return EvaluationOf("run", "fast", std::move(more))["return"] != 12345;
  };
  const auto mark = [&] { Write("run", "fast", marked.dump()); };
  mark();
  EXPECT_FALSE(is_repeated({"--episodes", "1"}));
  EXPECT_TRUE(is_repeated({"--episodes", "2"}));
  mark();
  ASSERT_EQ(Trainer({"resume", RunFolder("run"), "--episodes", "3", "--quiet"}).exit_status, 0);
  EXPECT_TRUE(is_repeated({"--episodes", "1"}));  // of the new checkpoint
  EXPECT_EQ(Read("run", "fast")["checkpoint_episode"], 3);
  marked = Read("run", "fast");
  marked["return"] = 12345;
  marked["version"] = "0.0.0";
  mark();
  EXPECT_TRUE(is_repeated({"--episodes", "1"}));
  Write("run", "fast", "{\"profile\": ");
  EXPECT_TRUE(is_repeated({"--episodes", "1"}));
}

TEST_F(EvaluateTest, SaysWhatIsMissing) {
  EXPECT_THAT(Failure("nowhere"), HasSubstr("there is no run in this folder"));
  EXPECT_EQ(Evaluate("nowhere", "slow").exit_status, 2);
  EXPECT_EQ(Trainer({"evaluate", RunFolder("nowhere")}).exit_status, 1);
  Train("run", 1, {"--quiet"});
  const ProgramResult without_profile = Trainer({"evaluate", RunFolder("run")});
  EXPECT_EQ(without_profile.exit_status, 2);
  EXPECT_THAT(without_profile.errors, HasSubstr("--profile is required"));
  RunDatabase::Open(RunFolder("run")).WriteCheckpoint({1, "no checkpoint at all"});
  EXPECT_THAT(Failure("run"), AllOf(HasSubstr("checkpoint"), HasSubstr("damaged")));
  RunDatabase::Create(RunFolder("new"), RunDatabase::OpenToRead(RunFolder("run")).ReadRun());
  EXPECT_THAT(Failure("new"), AllOf(HasSubstr("new: this run has no checkpoint yet"),
                                    HasSubstr("`trainer resume ")));
}

TEST_F(EvaluateTest, EvaluatesAllRunsOfAFolder) {
  Train("many", 2, {"--runs", "3", "--seed", "1", "--quiet"});
  const RunRecord record = RunDatabase::OpenToRead(RunFolder("many/seed3")).ReadRun();
  std::filesystem::remove_all(RunFolder("many/seed3"));
  RunDatabase::Create(RunFolder("many/seed3"), record);
  const ProgramResult text = Evaluate("many", "paper", {"--episodes", "1", "--jobs", "2"});
  EXPECT_EQ(text.exit_status, 0) << text.errors;
  EXPECT_THAT(text.output, AllOf(HasSubstr("\nseed1 "), HasSubstr("\nseed2 ")));
  EXPECT_EQ(text.errors, "seed3: left out: it has no checkpoint yet\n");
  const json both = {Read("many/seed1", "paper"), Read("many/seed2", "paper")};
  EXPECT_EQ(both[0], EvaluationOf("many/seed1", "paper", {"--episodes", "1"}));

  // What is there comes first, what is missing when it is done.
  std::filesystem::remove(File("many/seed1", "paper"));
  const std::vector<json> lines =
      Lines(Evaluate("many", "paper", {"--episodes", "1", "--json"}).output);
  ASSERT_THAT(lines, SizeIs(3));
  EXPECT_THAT((std::vector<json>{lines[0]["run"], lines[1]["run"], lines[2]["run"]}),
              ElementsAre("seed2", "seed1", "seed1"));
  EXPECT_EQ(lines[1]["episode"], 1);
  EXPECT_EQ(lines[2]["returns"], both[0]["returns"]);
}

TEST_F(EvaluateTest, ARunThatCannotBeEvaluatedCostsOnlyItself) {
  Train("many", 1, {"--runs", "2", "--seed", "1", "--quiet"});
  RunDatabase::Open(RunFolder("many/seed1")).WriteCheckpoint({1, "no checkpoint at all"});
  const ProgramResult result = Evaluate("many", "fast", {"--episodes", "1"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, AllOf(HasSubstr("seed1: given up: "), HasSubstr("damaged")));
  EXPECT_THAT(result.output, HasSubstr("\nseed2 "));
}

TEST_F(EvaluateTest, ARunAtWorkIsNotDisturbed) {
  const auto words = [&](const std::string& name) {
    std::vector<std::string> training =
        Training(name, 100'000, {"--json", "--checkpoint-every", "0"});
    training.insert(training.begin(), TRAINER);
    return training;
  };
  ChildProcess trainer(words("run"));
  ASSERT_TRUE(trainer.WaitForLines(3));
  const json evaluation = EvaluationOf("run", "fast", {"--episodes", "2"});
  const auto episode = evaluation["checkpoint_episode"].get<int>();
  EXPECT_GE(episode, 2);
  EXPECT_TRUE(trainer.WaitForLines(episode + 4));
  trainer.Send(SIGINT);
  EXPECT_EQ(trainer.Wait().exit_status, 128 + SIGINT);
  Train("alone", static_cast<int>(ReturnsOf("run").size()), {"--quiet"});
  EXPECT_EQ(ReturnsOf("alone"), ReturnsOf("run"));
}

TEST_F(EvaluateTest, CtrlCEndsItAndTheSameCallDoesTheRest) {
  Train("many", 1, {"--runs", "2", "--seed", "1", "--quiet"});
  ChildProcess evaluation({TRAINER, "evaluate", RunFolder("many"), "--profile", "fast",
                           "--episodes", "100000", "--jobs", "2", "--json"});
  ASSERT_TRUE(evaluation.WaitForLines(2));
  evaluation.Send(SIGINT);
  EXPECT_EQ(evaluation.Wait().exit_status, 128 + SIGINT);
  EXPECT_FALSE(std::filesystem::exists(File("many/seed1", "fast")));
  EXPECT_EQ(Evaluate("many", "fast", {"--episodes", "1"}).exit_status, 0);
}

}  // namespace
}  // namespace runtime
