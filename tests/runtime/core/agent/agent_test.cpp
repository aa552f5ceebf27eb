#include "runtime/core/agent/agent.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "runtime/core/module/composite.h"
#include "runtime/core/module/context.h"
#include "tests/golden.h"

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

ModuleGraph Build(const Agent& agent) { return BuildGraph(agent, TestTypes(), Context()); }

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

TEST(Agent, BuildsTheGraphThatItsFileDescribes) {
  const ModuleGraph graph = Build(ParseAgent(kAgent, "agent.toml"));
  auto& environment = graph.FindAs<Environment>("environment");
  auto& learner = graph.FindAs<Learner>("learner");
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
  const ModuleGraph graph = Build(agent);
  const auto& learner = graph.FindAs<Learner>("learner");
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
  const ModuleGraph graph = Build(Changed(ParseAgent(kAgent, "agent.toml"), changes));
  graph.FindAs<Environment>("environment").reward(2);
  EXPECT_THAT(graph.FindAs<Learner>("watcher").rewards, ElementsAre(2));
  EXPECT_THAT(graph.FindAs<Learner>("learner").rewards, ElementsAre(2));
}

TEST(Agent, ChangeOfTheTypeDropsTheOldTypesParameters) {
  const Agent changes = ParseAgent("[modules.learner]\ntype = 'Environment'\n", "task");
  const Agent agent = Changed(ParseAgent(kAgent, "agent.toml"), changes);
  EXPECT_EQ(agent.modules[1].type, "Environment");
  EXPECT_TRUE(agent.modules[1].parameters.empty());
}

TEST(Agent, AWholeAgentIsNoChangeOfAnother) {
  const Agent whole = ParseAgent("whole = true\n[modules.alone]\ntype = 'Environment'\n", "mine");
  const Agent agent = Changed(ParseAgent(kAgent, "agent.toml"), whole);
  EXPECT_THAT(NamesOf(agent.modules), ElementsAre("alone"));
  EXPECT_TRUE(agent.connections.empty());
  const Agent joined = Joined(whole, ParseAgent("[modules.more]\ntype = 'Learner'\n", "more"));
  const Agent both = Changed(ParseAgent(kAgent, "agent.toml"), joined);
  EXPECT_THAT(NamesOf(both.modules), ElementsAre("alone", "more"));
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
  const ModuleGraph graph = Build(agent);
  graph.Find("learner").Set("discount", 0.1);
  EXPECT_THAT(ToToml(Resolved(agent, graph)), testing::EndsWith(R"(
[modules.learner]
type = "Learner"
temperature = 2.0
discount = 0.1
policy = "boltzmann"
rates = [0.25, 1.0]
)"));
}

constexpr const char* kComposite = R"(connections = [
  ["environment.reward", "mind.reward"],
]

[modules.environment]
type = "Environment"

[modules.mind]
type = "Mind"
warmth = 3

[composites.Mind]
ports = {reward = "inner.reward", second = "other.reward"}
parameters = {warmth = "inner.temperature"}

[composites.Mind.modules.inner]
type = "Learner"
discount = 0.25

[composites.Mind.modules.other]
type = "Learner"
)";

TEST(Composite, IsAModuleOfModules) {
  const ModuleGraph graph = Build(ParseAgent(kComposite, "agent.toml"));
  auto& mind = graph.FindAs<Composite>("mind");
  auto& inner = mind.inner().FindAs<Learner>("inner");
  graph.FindAs<Environment>("environment").reward(1.5);
  EXPECT_THAT(inner.rewards, ElementsAre(1.5));
  EXPECT_EQ(inner.temperature, 3);
  EXPECT_EQ(inner.discount, 0.25);
  mind.Set("warmth", 7.0);
  EXPECT_EQ(inner.temperature, 7);
  EXPECT_EQ(std::get<double>(mind.Get("warmth")), 7);
  EXPECT_EQ(mind.FindPort("reward").full_name(), "mind.reward");
}

TEST(Composite, MayBeMadeOfComposites) {
  ModuleGraph graph = Build(ParseAgent(std::string(kComposite) + R"(
[modules.head]
type = "Head"
[composites.Head]
ports = {reward = "mind.second"}
[composites.Head.modules.mind]
type = "Mind"
)",
                                       "agent.toml"));
  graph.Connect("environment.reward", "head.reward");
  graph.FindAs<Environment>("environment").reward(2);
  const auto& mind = graph.FindAs<Composite>("head").inner().FindAs<Composite>("mind");
  EXPECT_THAT(mind.inner().FindAs<Learner>("other").rewards, ElementsAre(2));
  EXPECT_THAT(mind.inner().FindAs<Learner>("inner").rewards, testing::IsEmpty());
}

TEST(Composite, ResolvedAndWrittenIsTheSame) {
  const Agent agent = ParseAgent(kComposite, "agent.toml");
  const std::string toml = ToToml(Resolved(agent, Build(agent)));
  EXPECT_THAT(toml, testing::HasSubstr("[modules.mind]\ntype = \"Mind\"\nwarmth = 3.0\n"));
  EXPECT_THAT(toml, testing::HasSubstr("[composites.Mind.modules.inner]\ntype = \"Learner\"\n"
                                       "temperature = 3.0\ndiscount = 0.25\n"));
  const Agent again = ParseAgent(toml, "again.toml");
  EXPECT_EQ(ToToml(Resolved(again, Build(again))), toml);
}

TEST(Agent, PlacesTellWhereEverythingComesFrom) {
  const Agent agent = ParseAgent(kAgent, "agent.toml");
  const std::string toml = ToTomlWithPlaces(Resolved(agent, Build(agent)));
  EXPECT_THAT(toml, testing::ContainsRegex("temperature = 2.0 +# agent.toml:12:1\n"));
  EXPECT_THAT(toml, testing::ContainsRegex("discount = 0.9 +# default\n"));
  EXPECT_EQ(ToToml(ParseAgent(toml, "again")), ToToml(Resolved(agent, Build(agent))));
}

class IncludeTest : public testing::Test {
 protected:
  ~IncludeTest() override { std::filesystem::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  static std::string MistakeOf(const std::string& file) {
    try {
      ReadAgent(file, {});
      return "";
    } catch (const UserError& error) {
      return error.what();
    }
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("include-" + std::to_string(getpid()));
};

TEST_F(IncludeTest, BeginsWithWhatTheOtherFilesSay) {
  Write("parts/base.toml", kAgent);
  const std::string file =
      Write("mine.toml", "include = ['parts/base.toml']\n[modules.learner]\ntemperature = 9\n");
  const Agent agent = ReadAgent(file, {});
  EXPECT_EQ(Build(agent).FindAs<Learner>("learner").temperature, 9);
  EXPECT_THAT(NamesOf(agent.modules), ElementsAre("environment", "learner"));
  EXPECT_THAT(ToTomlWithPlaces(agent), testing::ContainsRegex("rates = .* # .*base.toml:11:1\n"));
}

TEST_F(IncludeTest, FilesThatChangeAnAgentCanIncludeOneAnother) {
  Write("warm.toml", "[modules.learner]\ntemperature = 9\n");
  const std::string file =
      Write("mine.toml", "include = ['warm.toml']\n[modules.learner]\ndiscount = 0.5\n");
  const ModuleGraph graph = Build(Changed(ParseAgent(kAgent, "agent.toml"), ReadAgent(file, {})));
  EXPECT_EQ(graph.FindAs<Learner>("learner").temperature, 9);
  EXPECT_EQ(graph.FindAs<Learner>("learner").discount, 0.5);
}

TEST_F(IncludeTest, AgentsOfTheRobotAreIncludedByTheirNames) {
  Write("robot/calm.agent.toml", "[modules.learner]\ntemperature = 2\n");
  const std::string file =
      Write("mine.toml", "include = ['calm']\n[modules.learner]\ndiscount = 0.5\n");
  const Agent changes = ReadAgent(file, folder_ / "robot");
  const ModuleGraph graph = Build(Changed(ParseAgent(kAgent, "agent.toml"), changes));
  EXPECT_EQ(graph.FindAs<Learner>("learner").temperature, 2);
  EXPECT_EQ(graph.FindAs<Learner>("learner").discount, 0.5);
}

TEST_F(IncludeTest, CircleIsRefused) {
  const std::string a = Write("a.toml", "include = ['b.toml']\n");
  Write("b.toml", "include = ['a.toml']\n");
  EXPECT_THAT(MistakeOf(a), testing::EndsWith("b.toml:1:12: `a.toml` includes itself"));
}

TEST_F(IncludeTest, MissingFileIsNamed) {
  const std::string file = Write("a.toml", "\ninclude = ['c.toml']\n");
  EXPECT_THAT(MistakeOf(file), testing::EndsWith("c.toml`"));
  EXPECT_THAT(MistakeOf(file), testing::HasSubstr("a.toml:2:12: there is no file `"));
}

TEST(ReadAgent, FileThatIsNotThereIsRefused) {
  for (const std::string file : {TEST_FOLDER "/nowhere.toml", TEST_FOLDER}) {
    try {
      ReadAgent(file, {});
      FAIL();
    } catch (const UserError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(file + ": cannot be read: "));
    }
  }
}

// errors/NAME.toml has one mistake; behind it stands what is said about it.
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
  const std::filesystem::path file = TEST_FOLDER "/errors/" + GetParam() + ".toml";
  std::string message = "no error\n";
  try {
    Build(ParseAgent(golden::ReadInput(file), file.filename()));
  } catch (const UserError& error) {
    message = std::string(error.what()) + "\n";
  }
  golden::ExpectBehindInput(file, message);
}

INSTANTIATE_TEST_SUITE_P(Agent, MistakeTest, testing::ValuesIn(Mistakes()),
                         [](const auto& mistake) { return mistake.param; });

}  // namespace
}  // namespace runtime
