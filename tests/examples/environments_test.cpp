// The worlds of examples/environments as their page says: made to libraries, learned in, evaluated.
#include <gmock/gmock.h>

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/training/run/policy_evaluation.h"
#include "runtime/training/run/run_database.h"
#include "tests/runtime/trainer/child_process.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace examples {
namespace {

using runtime::ProgramResult;
using runtime::RunProgram;
using testing::HasSubstr;

class Worlds : public testing::Test {
 protected:
  // The libraries lie beside copies of the tasks and agents.
  static std::string TaskOf(const std::string& world) {
    return std::string(WORLDS) + "/" + world + ".task";
  }
  std::string Run(const char* name) const { return (folder_.path() / name).string(); }

  ProgramResult Train(const std::string& world, const std::string& run, int episodes,
                      const std::vector<std::string>& options = {}) const {
    std::vector<std::string> words = {
        TRAINER, "train", TaskOf(world), "--seed", "1", "--episodes", std::to_string(episodes),
        "--out", run,     "--quiet"};
    words.insert(words.end(), options.begin(), options.end());
    return RunProgram(words);
  }
  // How what was learned acts without learning on.
  static runtime::PolicyEvaluation Evaluate(const std::string& run) {
    const ProgramResult result =
        RunProgram({TRAINER, "evaluate", run, "--episodes", "1", "--quiet"});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return runtime::ReadEvaluation(runtime::EvaluationFile(run, ""));
  }
  static std::vector<double> Returns(const std::string& run) {
    std::vector<double> returns;
    for (const auto& episode : runtime::RunDatabase::OpenToRead(run).ReadEpisodes()) {
      returns.push_back(episode.active.episode_return);
    }
    return returns;
  }

  runtime::TemporaryFolder folder_;
};

// 15 steps: 1 - 15 * 0.01.
TEST_F(Worlds, TheShortestPathThroughTheMazeIsFound) {
  const ProgramResult result = Train("grid_maze", Run("maze"), 200);
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  const runtime::PolicyEvaluation evaluation = Evaluate(Run("maze"));
  EXPECT_EQ(evaluation.metrics.at("steps"), 15);
  EXPECT_NEAR(evaluation.mean_return, 0.85, 1e-9);
}

TEST_F(Worlds, TheCarLearnsToGetUpTheHill) {
  const ProgramResult result = Train("mountain_car", Run("car"), 200);
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_EQ(Evaluate(Run("car")).ends.count("success"), 1u);
}

TEST_F(Worlds, TheWayThroughTheMazeInThePlaneIsFound) {
  const ProgramResult result = Train("plane_maze", Run("plane"), 400);
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_EQ(Evaluate(Run("plane")).ends.count("success"), 1u);
}

TEST_F(Worlds, ALearnerOfTodayGetsTheCarUpTheHill) {
  const ProgramResult result =
      Train("mountain_car", Run("ppo"), 300, {"--agent", "ppo", "--jobs", "2"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_EQ(Evaluate(Run("ppo")).ends.count("success"), 1u);
}

TEST_F(Worlds, ARunGoesOnBitForBit) {
  ASSERT_EQ(Train("mountain_car", Run("whole"), 8).exit_status, 0);
  ASSERT_EQ(Train("mountain_car", Run("parts"), 5).exit_status, 0);
  const ProgramResult rest =
      RunProgram({TRAINER, "resume", Run("parts"), "--episodes", "8", "--quiet"});
  ASSERT_EQ(rest.exit_status, 0) << rest.errors;
  EXPECT_EQ(Returns(Run("parts")), Returns(Run("whole")));
}

TEST_F(Worlds, ARunWithoutARobotShowsWhatThereIs) {
  ASSERT_EQ(Train("grid_maze", Run("maze"), 3).exit_status, 0);
  const ProgramResult shown = RunProgram({TRAINER, "show", Run("maze")});
  EXPECT_EQ(shown.exit_status, 0) << shown.errors;
  EXPECT_THAT(shown.output, HasSubstr("3 of 3"));
  EXPECT_THAT(shown.output, testing::Not(HasSubstr("robot")));
  EXPECT_EQ(RunProgram({TRAINER, "report", Run("maze")}).exit_status, 0);
  const auto refusal = [](const std::vector<std::string>& words) {
    return RunProgram(words).errors;
  };
  EXPECT_THAT(refusal({TRAINER, "evaluate", Run("maze"), "--profile", "fast"}),
              HasSubstr("the environment of this run has no profiles: leave --profile away"));
  EXPECT_THAT(refusal({TRAINER, "snapshots", Run("maze"), "--output", Run("x.png")}),
              HasSubstr("the run has no robot, and so records no motion"));
  EXPECT_THAT(refusal({TRAINER, "export", Run("maze"), "--onnx", Run("x.onnx")}),
              HasSubstr("the policy cannot be exported: the run has no robot"));
}

TEST_F(Worlds, WhatDoesNotFitATaskWithoutARobotIsRefused) {
  const auto refusal = [&](const std::vector<std::string>& options) {
    return Train("mountain_car", Run("none"), 1, options).errors;
  };
  EXPECT_THAT(refusal({"--agent", "motion_search"}),
              HasSubstr("is made for a robot, and the task names none"));
  EXPECT_THAT(refusal({"--profile", "fast"}),
              HasSubstr("the agent has no module of the type `RobotEnvironment` to set it in"));
  EXPECT_THAT(refusal({"--set", "action_space.actions=[0.2, 0]", "--set", "environment.force=2"}),
              HasSubstr("force"));
}

}  // namespace
}  // namespace examples
