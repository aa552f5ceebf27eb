#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

class AgentShowTest : public TrainerTest {
 protected:
  ProgramResult Show(std::vector<std::string> more) const {
    std::vector<std::string> words = {"agent", "show", TaskFile("leaning")};
    words.insert(words.end(), more.begin(), more.end());
    return Trainer(words);
  }
};

TEST_F(AgentShowTest, SaysWhereEverythingComesFrom) {
  const ProgramResult result = Show({"--set", "learner.temperature=2", "--profile", "fast"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, ContainsRegex("temperature = 2.0 +# --set learner.temperature=2\n"));
  EXPECT_THAT(result.output, ContainsRegex("discount = 0.9 +# .*agent.toml:[0-9]+:1\n"));
  EXPECT_THAT(result.output, ContainsRegex("profile = \"fast\" +# --profile fast\n"));
  EXPECT_THAT(result.output, ContainsRegex("start_pose = \"\" +# default\n"));
  EXPECT_THAT(result.output, ContainsRegex("net_seed = [0-9]+ +# default\n"));
}

TEST_F(AgentShowTest, DrawsTheGraph) {
  EXPECT_THAT(Show({"--format", "dot"}).output, StartsWith("digraph agent {"));
  EXPECT_THAT(Show({"--format", "text"}).output, HasSubstr("  reward -> learner.reward  (real)\n"));
  const auto json = nlohmann::json::parse(Show({"--json"}).output);
  EXPECT_EQ(json["modules"].size(), 6u);
}

TEST_F(AgentShowTest, AWholeAgentTakesThePlaceOfTheRobots) {
  const std::string file = (folder() / "mine.toml").string();
  const std::string world = "whole = true\n[modules.world]\ntype = \"RobotEnvironment\"\n";
  std::ofstream(file) << world;
  const std::string shown = Show({"--agent", file, "--profile", "fast"}).output;
  EXPECT_THAT(shown, StartsWith("connections = [\n]\n\n[modules.world] "));
  EXPECT_THAT(shown, ContainsRegex("profile = \"fast\" +# --profile fast\n"));
  std::ofstream(file) << world << "start_pose = \"lying\"\n";
  EXPECT_THAT(Show({"--agent", file}).output,
              ContainsRegex("start_pose = \"lying\" +# .*mine.toml:4:1\n"));
}

TEST_F(AgentShowTest, MistakeInASettingNamesTheSetting) {
  const ProgramResult result = Show({"--set", "learner.temperature=[1"});
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_THAT(result.errors, HasSubstr("--set learner.temperature=[1: "));
}

}  // namespace
}  // namespace runtime
