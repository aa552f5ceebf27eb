#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsSupersetOf;
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

TEST_F(AgentShowTest, OneOfTheRobotsAgentsIsFoundByItsName) {
  const ProgramResult result = Show({"--agent", "ppo"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, ContainsRegex("batch = 1024 +# .*ppo.agent.toml:[0-9]+:1\n"));
  EXPECT_THAT(Show({"--agent", "paper"}).output, HasSubstr("type = \"PengQLambda\""));
  EXPECT_THAT(Show({}).output, HasSubstr("type = \"PengQLambda\""));
}

TEST_F(AgentShowTest, ATaskChangesEachOfTheRobotsAgentsByAFileOfItsOwn) {
  const std::filesystem::path task = folder() / "mine.task";
  std::filesystem::copy_file(TaskFile("leaning"), task);
  std::ofstream(folder() / "mine.ppo.agent.toml") << "[modules.action_space]\ndof = \"all\"\n";
  const auto show = [&](const std::string& agent) {
    return Trainer({"agent", "show", task.string(), "--agent", agent}).output;
  };
  EXPECT_THAT(show("ppo"), ContainsRegex("dof = \"all\" +# .*mine.ppo.agent.toml:2:1\n"));
  EXPECT_THAT(show("paper"), HasSubstr("dof = \"5\""));
  const std::string file = (folder() / "other.toml").string();
  std::ofstream(file) << "[modules.learner]\ndiscount = 0.5\n";
  EXPECT_THAT(show(file), AllOf(HasSubstr("discount = 0.5"), HasSubstr("dof = \"5\"")));
}

TEST_F(AgentShowTest, UnknownAgentsShowTheNearestName) {
  const ProgramResult name = Show({"--agent", "pppo"});
  EXPECT_EQ(name.exit_status, 2);
  EXPECT_THAT(name.errors, HasSubstr("--agent pppo: the robot has no such agent"));
  EXPECT_THAT(name.errors, HasSubstr("`ppo`"));
  const ProgramResult file = Show({"--agent", "nowhere.toml"});
  EXPECT_EQ(file.exit_status, 2);
  EXPECT_THAT(file.errors, HasSubstr("--agent nowhere.toml: there is no such file"));
}

TEST_F(AgentShowTest, NamesThatBeginWithADigitNeedNoQuotes) {
  const ProgramResult result = Show({"--agent", "motion_search", "--set", "action_space.dof=7",
                                     "--set", "action_space.kind=one_shot"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("dof = \"7\""));
  const ProgramResult net = Show({"--set", "features.net=3_g5", "--set", "state.dof=3"});
  EXPECT_EQ(net.exit_status, 0) << net.errors;
  EXPECT_THAT(net.output, HasSubstr("net = \"3_g5\""));
  EXPECT_THAT(net.output, HasSubstr("dof = \"3\""));
}

TEST_F(AgentShowTest, AgentsAreListed) {
  EXPECT_THAT(Trainer({"agent", "list"}).output,
              ContainsRegex("ppo +humanoid +Proximal policy optimization"));
  const auto json = nlohmann::json::parse(Trainer({"agent", "list", "--json"}).output);
  std::vector<std::string> agents;
  for (const auto& agent : json) {
    agents.push_back(agent["robot"].get<std::string>() + " " + agent["name"].get<std::string>());
  }
  EXPECT_THAT(agents, IsSupersetOf({"humanoid paper", "humanoid ppo", "rover ppo"}));
}

TEST_F(AgentShowTest, MistakeInASettingNamesTheSetting) {
  const ProgramResult result = Show({"--set", "learner.temperature=[1"});
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_THAT(result.errors, HasSubstr("--set learner.temperature=[1: "));
}

}  // namespace
}  // namespace runtime
