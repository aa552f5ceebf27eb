// That what is exported of a policy decides what the policy does.
#include <fstream>

#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::HasSubstr;

class ExportPolicyTest : public TrainerTest {
 protected:
  // Trains PPO on `task` for long enough to learn a few times.
  void TrainPpo(const std::string& task, std::vector<std::string> more = {},
                const std::string& agent = "ppo") const {
    std::vector<std::string> words = {
        "train",     TaskFile(task),       "--agent",    agent,
        "--profile", "fast-tree",          "--episodes", "12",
        "--out",     RunFolder("run"),     "--set",      "learner.batch=20",
        "--set",     "learner.minibatch=8"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramResult result = Trainer(words);
    ASSERT_EQ(result.exit_status, 0) << result.errors;
  }
  ProgramResult Export(std::vector<std::string> files) const {
    files.insert(files.begin(), {"export", RunFolder("run")});
    return Trainer(files);
  }
  // Exports the run's policy in all ways, and lets others decide as it has decided.
  void ExpectSameDecisions() const {
    const ProgramResult result =
        Export({"--onnx", RunFolder("policy.onnx"), "--c-header", RunFolder("policy.h"),
                "--decisions", RunFolder("decisions.csv")});
    ASSERT_EQ(result.exit_status, 0) << result.errors;
    DecideInC();
#ifdef ONNXRUNTIME
    const ProgramResult onnx = RunProgram(
        {NODE, ONNXRUNTIME "/decide.mjs", RunFolder("policy.onnx"), RunFolder("decisions.csv")});
    EXPECT_EQ(onnx.exit_status, 0) << onnx.output << onnx.errors;
#endif
  }
  std::string Text(const std::string& file) const {
    std::ifstream in(RunFolder(file));
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  void DecideInC() const {
    const ProgramResult built =
        RunProgram({"/usr/bin/env", "cc", "-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror",
                    "-I" + folder().string(), SOURCE_DIR "/tests/runtime/trainer/decide.c", "-o",
                    RunFolder("decide"), "-lm"});
    ASSERT_EQ(built.exit_status, 0) << built.errors;
    const ProgramResult decided = RunProgram({RunFolder("decide"), RunFolder("decisions.csv")});
    EXPECT_EQ(decided.exit_status, 0) << decided.output;
  }
};

TEST_F(ExportPolicyTest, OfWhatTheRobotSenses) {
  TrainPpo("leaning", {"--set", "action_space.dof=all", "--set", "action_space.hold=4"});
  ExpectSameDecisions();
  EXPECT_THAT(Text("policy.h"), HasSubstr("// Call policy_step() every 0.02 s"));
  EXPECT_THAT(Text("policy.h"), HasSubstr("// (joint.angle - joint.rest)[neck_yaw] [rad]\n"));
}

TEST_F(ExportPolicyTest, OfWhatTheTaskObserves) {
  TrainPpo("seeing");
  ExpectSameDecisions();
  EXPECT_THAT(Text("policy.h"), HasSubstr("  POLICY_OBSERVATION_LEAN,  // lean\n"));
  EXPECT_THAT(Text("decisions.csv"), HasSubstr("action/"));
}

class ExportPolicyOnMotionTest : public ExportPolicyTest {
 protected:
  // With what a short search finds to stand on.
  void TrainOnMotion(const std::vector<std::string>& shape) const {
    std::vector<std::string> words = {
        "train",     TaskFile("leaning"), "--agent", "motion_search", "--profile",
        "fast-tree", "--episodes",        "6",       "--out",         RunFolder("search")};
    for (const std::string& setting : shape) words.insert(words.end(), {"--set", setting});
    const ProgramResult search = Trainer(words);
    ASSERT_EQ(search.exit_status, 0) << search.errors;
    const ProgramResult file =
        Trainer({"export", RunFolder("search"), "--motion", RunFolder("motion.toml")});
    ASSERT_EQ(file.exit_status, 0) << file.errors;
    TrainPpo("leaning", {}, RunFolder("motion.toml"));
  }
};

TEST_F(ExportPolicyOnMotionTest, Periodic) {
  TrainOnMotion({"action_space.dof=5", "action_space.harmonics=3"});
  ExpectSameDecisions();
  EXPECT_THAT(Text("policy.h"), HasSubstr("how far the targets are from a motion"));
  EXPECT_THAT(Text("decisions.csv"), HasSubstr("joint_offsets/neck_yaw [rad]"));
}

TEST_F(ExportPolicyOnMotionTest, DoneOnce) {
  TrainOnMotion({"action_space.dof=5", "action_space.kind=one_shot"});
  ExpectSameDecisions();
}

TEST_F(ExportPolicyTest, SaysWhichLearnersHaveOne) {
  Train("run", 2);
  const ProgramResult result = Export({"--onnx", RunFolder("policy.onnx")});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors,
              HasSubstr("the policy of `learner`, a PengQLambda, cannot be exported"));
  EXPECT_THAT(result.errors, HasSubstr("those of these learners are: Ppo"));
}

}  // namespace
}  // namespace runtime
