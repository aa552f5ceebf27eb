#include "runtime/agent/agent.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "runtime/module/context.h"

namespace runtime {
namespace {

using testing::ElementsAre;

class Environment : public Module {
 public:
  Environment(std::string name, const Context&) : Module(std::move(name)) {}

  double height = 3;
  Signal<double> reward{this, "reward"};
  Out<double> level{this, "level", &height};
};

class Learner : public Module {
 public:
  Learner(std::string name, const Context&) : Module(std::move(name)) {
    AddParameter({"temperature", "", &temperature});
    AddParameter({"discount", "", &discount, {}, 0, 1});
    AddParameter({"policy", "", &policy, {"boltzmann", "greedy"}});
    AddParameter({"rates", "", &rates});
  }
  void OnReward(double value) { rewards.push_back(value); }

  double temperature = 5;
  double discount = 0.9;
  std::string policy = "boltzmann";
  std::vector<double> rates{0.5};
  std::vector<double> rewards;
  Slot<double> reward{this, "reward", Bind<&Learner::OnReward>{}};
  In<double> level{this, "level"};
};

ModuleTypes TestTypes() {
  ModuleTypes types;
  types.Add<Environment>("Environment");
  types.Add<Learner>("Learner");
  return types;
}

Network Build(const Agent& agent) { return BuildNetwork(agent, TestTypes(), Context()); }

std::string Text(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

constexpr const char* kAgent = R"(connections = [
  ["environment.reward", "learner.reward"],
  ["environment.*", "learner.*"],
]

[modules.environment]
type = "Environment"

[modules.learner]
type = "Learner"
rates = [0.25, 1]
temperature = 2
)";

std::vector<std::string> NamesOf(const std::vector<ModuleSetting>& modules) {
  std::vector<std::string> names;
  for (const ModuleSetting& module : modules) names.push_back(module.name);
  return names;
}

TEST(Agent, BuildsTheNetworkThatItsFileDescribes) {
  const Network network = Build(ParseAgent(kAgent, "agent.toml"));
  auto& environment = network.FindAs<Environment>("environment");
  auto& learner = network.FindAs<Learner>("learner");
  EXPECT_EQ(learner.temperature, 2);
  EXPECT_EQ(learner.discount, 0.9);
  EXPECT_THAT(learner.rates, ElementsAre(0.25, 1));
  environment.reward(1.5);
  EXPECT_THAT(learner.rewards, ElementsAre(1.5));
  EXPECT_EQ(&learner.level(), &environment.height);
}

TEST(Agent, KeepsTheOrderOfItsFile) {
  const Agent agent = ParseAgent(
      "[modules.zebra]\ntype = 'Learner'\n[modules.bear]\ntype = 'Learner'\n"
      "rates = [1]\ndiscount = 0.5\n[modules.ape]\ntype = 'Environment'\n",
      "agent.toml");
  EXPECT_THAT(NamesOf(agent.modules), ElementsAre("zebra", "bear", "ape"));
  EXPECT_EQ(agent.modules[1].parameters[0].name, "rates");
  EXPECT_EQ(agent.modules[1].parameters[1].name, "discount");
}

TEST(Agent, ChangeReplacesSingleParameters) {
  const Agent changes = ParseAgent("[modules.learner]\ntemperature = 1\ndiscount = 0.5", "task");
  const Agent agent = Changed(ParseAgent(kAgent, "agent.toml"), changes);
  const Network network = Build(agent);
  const auto& learner = network.FindAs<Learner>("learner");
  EXPECT_EQ(learner.temperature, 1);
  EXPECT_EQ(learner.discount, 0.5);
  EXPECT_THAT(learner.rates, ElementsAre(0.25, 1));
  EXPECT_THAT(NamesOf(agent.modules), ElementsAre("environment", "learner"));
}

TEST(Agent, ChangeAddsModulesAndConnections) {
  const Agent changes = ParseAgent(
      "connections = [['environment.reward', 'watcher.reward']]\n"
      "[modules.watcher]\ntype = 'Learner'\n",
      "task");
  const Network network = Build(Changed(ParseAgent(kAgent, "agent.toml"), changes));
  network.FindAs<Environment>("environment").reward(2);
  EXPECT_THAT(network.FindAs<Learner>("watcher").rewards, ElementsAre(2));
  EXPECT_THAT(network.FindAs<Learner>("learner").rewards, ElementsAre(2));
}

TEST(Agent, ChangeOfTheTypeDropsTheOldTypesParameters) {
  const Agent changes = ParseAgent("[modules.learner]\ntype = 'Environment'\n", "task");
  const Agent agent = Changed(ParseAgent(kAgent, "agent.toml"), changes);
  EXPECT_EQ(agent.modules[1].type, "Environment");
  EXPECT_TRUE(agent.modules[1].parameters.empty());
}

TEST(Agent, ChangeThatNamesTheSameTypeKeepsTheParameters) {
  const Agent changes =
      ParseAgent("[modules.learner]\ntype = 'Learner'\ntemperature = 9\n", "task");
  const Agent agent = Changed(ParseAgent(kAgent, "agent.toml"), changes);
  EXPECT_EQ(agent.modules[1].parameters.size(), 2u);
}

TEST(Agent, ChangeOfAnUnknownModuleIsRefused) {
  const Agent changes = ParseAgent("\n[modules.laerner]\ntemperature = 1", "turning.agent.toml");
  try {
    Changed(ParseAgent(kAgent, "agent.toml"), changes);
    FAIL();
  } catch (const UserError& error) {
    EXPECT_STREQ(
        error.what(),
        "turning.agent.toml:2:10: the agent has no module `laerner` to change: did you mean "
        "`learner`? (a new one needs a `type`)");
  }
}

TEST(Agent, ComplaintAboutAChangedParameterNamesTheFileThatChangesIt) {
  const Agent changes = ParseAgent("[modules.learner]\n\ndiscount = 7", "task.toml");
  try {
    Build(Changed(ParseAgent(kAgent, "agent.toml"), changes));
    FAIL();
  } catch (const UserError& error) {
    EXPECT_STREQ(error.what(),
                 "task.toml:3:1: `learner.discount` must lie in 0 .. 1, and 7 does not");
  }
}

TEST(Agent, TomlReadsBackToTheSameAgent) {
  const std::string toml = ToToml(ParseAgent(kAgent, "agent.toml"));
  EXPECT_EQ(toml, R"(connections = [
  ["environment.reward", "learner.reward"],
  ["environment.*", "learner.*"],
]

[modules.environment]
type = "Environment"

[modules.learner]
type = "Learner"
rates = [0.25, 1.0]
temperature = 2
)");
  EXPECT_EQ(ToToml(ParseAgent(toml, "again")), toml);
}

TEST(Agent, TomlQuotesWhatNeedsQuotes) {
  const std::string toml = ToToml(
      ParseAgent("[modules.'my learner']\ntype = 'Learner'\npolicy = \"a\\\"b\\\\\\n\"", "agent"));
  EXPECT_EQ(toml,
            "connections = [\n]\n\n[modules.\"my learner\"]\ntype = \"Learner\"\n"
            "policy = \"a\\\"b\\\\\\u000a\"\n");
  EXPECT_EQ(ToToml(ParseAgent(toml, "again")), toml);
}

TEST(Agent, ResolvedAgentHasEveryParameter) {
  const Agent agent = ParseAgent(kAgent, "agent.toml");
  const Network network = Build(agent);
  network.Find("learner").Set("discount", 0.1);
  EXPECT_THAT(ToToml(Resolved(agent, network)), testing::EndsWith(R"(
[modules.learner]
type = "Learner"
temperature = 2.0
discount = 0.1
policy = "boltzmann"
rates = [0.25, 1.0]
)"));
}

TEST(ReadAgent, FileThatIsNotThereIsRefused) {
  for (const std::string file : {TEST_FOLDER "/nowhere.toml", TEST_FOLDER}) {
    try {
      ReadAgent(file);
      FAIL();
    } catch (const UserError& error) {
      EXPECT_EQ(error.what(), file + ": cannot be read");
    }
  }
}

// errors/NAME.toml has one mistake; errors/NAME.txt is what is said about it. To accept new
// messages, run with UPDATE_GOLDEN=1 and look at the difference.
std::vector<std::string> Mistakes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(TEST_FOLDER "/errors")) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class MistakeTest : public testing::TestWithParam<std::string> {};

TEST_P(MistakeTest, IsReportedWithItsPlace) {
  const std::filesystem::path folder = TEST_FOLDER "/errors";
  const std::string file = GetParam() + ".toml";
  std::string message = "no error\n";
  try {
    Build(ParseAgent(Text(folder / file), file));
  } catch (const UserError& error) {
    message = std::string(error.what()) + "\n";
  }
  const std::filesystem::path golden = folder / (GetParam() + ".txt");
  if (std::getenv("UPDATE_GOLDEN") != nullptr) std::ofstream(golden) << message;
  EXPECT_EQ(message, Text(golden));
}

INSTANTIATE_TEST_SUITE_P(Agent, MistakeTest, testing::ValuesIn(Mistakes()),
                         [](const auto& mistake) { return mistake.param; });

}  // namespace
}  // namespace runtime
