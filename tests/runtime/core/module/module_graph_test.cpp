#include "runtime/core/module/module_graph.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "runtime/core/module/connections.h"
#include "runtime/core/module/context.h"
#include "runtime/core/module/graph_text.h"
#include "tests/runtime/core/module/test_modules.h"

namespace runtime {
namespace {

using testing::ElementsAre;

class ModuleGraphTest : public testing::Test {
 protected:
  ModuleGraphTest() {
    graph_.Add(std::make_unique<Source>("environment"));
    graph_.Add(std::make_unique<Sink>("task"));
  }

  static std::string MessageOf(const std::function<void()>& action) {
    try {
      action();
    } catch (const UserError& error) {
      return error.what();
    }
    return "no error";
  }

  Source& source() { return graph_.FindAs<Source>("environment"); }
  Sink& sink() { return graph_.FindAs<Sink>("task"); }

  ModuleGraph graph_;
};

TEST_F(ModuleGraphTest, ConnectsByName) {
  graph_.Connect("environment.reward", "task.reward");
  graph_.Connect("task.level", "environment.level");
  graph_.Connect("environment.base.velocity", "task.base.velocity");
  source().reward(3);
  EXPECT_THAT(sink().received, ElementsAre(3));
  EXPECT_EQ(sink().level(), 2.5);
  EXPECT_EQ(&sink().velocity(), &source().velocity_data);
}

TEST_F(ModuleGraphTest, DisconnectsByName) {
  graph_.Connect("environment.reward", "task.reward");
  graph_.Disconnect("task.reward", "environment.reward");
  source().reward(3);
  EXPECT_TRUE(sink().received.empty());
}

TEST_F(ModuleGraphTest, StarConnectsEachInPortThatHasNoConnectionToTheOutPortOfItsName) {
  graph_.Connect("environment.still", "task.level");
  graph_.Connect("environment.*", "task.*");
  EXPECT_EQ(&sink().level(), &source().level_value);
  EXPECT_EQ(source().refreshes, 0);
  EXPECT_TRUE(sink().velocity.connected());
  EXPECT_FALSE(sink().position.connected());
  EXPECT_TRUE(source().reward.Connections().empty());
}

TEST_F(ModuleGraphTest, StarOnOneSideOnlyIsRefused) {
  EXPECT_EQ(
      MessageOf([&] { graph_.Connect("environment.*", "task.level"); }),
      "cannot connect `environment.*` to `task.level`: `*` stands for all ports on both sides or "
      "on none");
}

TEST_F(ModuleGraphTest, UnknownNamesGetTheNearestOne) {
  EXPECT_EQ(MessageOf([&] { graph_.Connect("enviroment.reward", "task.reward"); }),
            "there is no module `enviroment`: did you mean `environment`?");
  EXPECT_EQ(MessageOf([&] { graph_.Connect("environment.rewrad", "task.reward"); }),
            "the module `environment` has no port `rewrad`: did you mean `reward`?");
  EXPECT_EQ(MessageOf([&] { graph_.Find("x"); }),
            "there is no module `x`; there are `environment`, `task`");
  EXPECT_EQ(MessageOf([&] { graph_.FindPort("environment"); }),
            "`environment` is not a port: write MODULE.PORT");
}

TEST_F(ModuleGraphTest, TypesThatDifferAreRefusedWithThePortsThatWouldFit) {
  EXPECT_EQ(MessageOf([&] { graph_.Connect("environment.reward", "task.end"); }),
            "cannot connect `environment.reward` to `task.end`: the types differ: "
            "`environment.reward` is `(real)`, `task.end` is `(episode end)`; "
            "`environment.reward` fits `task.reward`");
  EXPECT_EQ(MessageOf([&] { graph_.Connect("environment.level", "task.base.position"); }),
            "cannot connect `environment.level` to `task.base.position`: the types differ: "
            "`environment.level` is `real`, `task.base.position` is `vec3 [m]`; "
            "`environment.level` fits `task.level`");
}

TEST_F(ModuleGraphTest, NamesOfModulesAreUniqueAndHaveNoDot) {
  EXPECT_EQ(MessageOf([&] { graph_.Add(std::make_unique<Sink>("task")); }),
            "there is a module `task` already");
  EXPECT_EQ(MessageOf([&] { graph_.Add(std::make_unique<Sink>("a.b")); }),
            "`a.b` cannot name a module: a name has no '.'");
}

TEST_F(ModuleGraphTest, ModuleOfAnotherClassIsRefused) {
  EXPECT_THROW(graph_.FindAs<Sink>("environment"), UserError);
}

TEST_F(ModuleGraphTest, ModulesAreFoundByWhatTheyAre) {
  EXPECT_EQ(&graph_.FindOnly<Sink>(), &sink());
  Module& second = graph_.Add(std::make_unique<Sink>("second"));
  EXPECT_THAT(graph_.FindAll<Sink>(), testing::ElementsAre(&sink(), &second));
  EXPECT_EQ(MessageOf([&] { graph_.FindOnly<Sink>(); }),
            "the agent has two sinks, `task` and `second`: keep one");
  graph_.Remove("task");
  graph_.Remove("second");
  EXPECT_EQ(MessageOf([&] { graph_.FindOnly<Sink>(); }),
            "the agent has no sink: one of its modules, outside of composites, must be one");
}

TEST_F(ModuleGraphTest, TextListsModulesAndConnections) {
  graph_.Connect("environment.reward", "task.reward");
  graph_.Connect("environment.*", "task.*");
  EXPECT_EQ(GraphText(graph_),
            "environment\n"
            "  reward -> task.reward  (real)\n"
            "  level -> task.level  real\n"
            "  base.velocity -> task.base.velocity  vec3 [m/s]\n"
            "task\n");
}

TEST_F(ModuleGraphTest, JsonListsModulesPortsAndConnections) {
  graph_.Connect("environment.reward", "task.reward");
  const auto json = nlohmann::json::parse(GraphJson(graph_));
  ASSERT_EQ(json["modules"].size(), 2u);
  EXPECT_EQ(json["modules"][0]["name"], "environment");
  EXPECT_EQ(json["modules"][0]["ports"][0],
            (nlohmann::json{{"name", "reward"}, {"kind", "signal"}, {"type", "(real)"}}));
  EXPECT_EQ(json["connections"],
            nlohmann::json::array(
                {{{"from", "environment.reward"}, {"to", "task.reward"}, {"type", "(real)"}}}));
}

TEST_F(ModuleGraphTest, DotDrawsSignalsFullAndValuesDashed) {
  graph_.Connect("environment.reward", "task.reward");
  graph_.Connect("environment.level", "task.level");
  const std::string dot = GraphDot(graph_);
  EXPECT_THAT(dot, testing::StartsWith("digraph agent {\n"));
  EXPECT_THAT(dot, testing::HasSubstr("  \"environment\" -> \"task\" [taillabel=\"reward\", "
                                      "headlabel=\"reward\"];\n"));
  EXPECT_THAT(dot, testing::HasSubstr("headlabel=\"level\", style=dashed];\n"));
}

TEST_F(ModuleGraphTest, RemovedModuleIsDisconnected) {
  graph_.Connect("environment.reward", "task.reward");
  graph_.Remove("task");
  EXPECT_THAT(graph_.FindPort("environment.reward").Connections(), testing::IsEmpty());
  EXPECT_THROW(graph_.Find("task"), UserError);
  EXPECT_THROW(graph_.Remove("task"), UserError);
}

// Keeps one number in checkpoints.
class Keeper : public Module {
 public:
  explicit Keeper(std::string name, char initial = '0') : Module(std::move(name)), value(initial) {}
  void Save(std::ostream& stream) const override { stream.put(value); }
  void Load(std::istream& stream) override { stream.get(value); }
  char value;
};

TEST(ModuleGraphState, ComesBack) {
  ModuleGraph saved;
  saved.Add(std::make_unique<Keeper>("a", '1'));
  saved.Add(std::make_unique<Keeper>("b", '2'));
  std::stringstream state;
  saved.Save(state);
  ModuleGraph loaded;
  auto& a = static_cast<Keeper&>(loaded.Add(std::make_unique<Keeper>("a")));
  auto& b = static_cast<Keeper&>(loaded.Add(std::make_unique<Keeper>("b")));
  loaded.Load(state);
  EXPECT_EQ(a.value, '1');
  EXPECT_EQ(b.value, '2');
}

TEST(ModuleGraphState, OfOtherModulesOrDamagedIsRefused) {
  ModuleGraph saved;
  saved.Add(std::make_unique<Keeper>("a", '1'));
  std::stringstream stream;
  saved.Save(stream);
  const std::string state = stream.str();
  for (size_t size = 0; size < state.size(); ++size) {
    std::istringstream cut(state.substr(0, size));
    EXPECT_THROW(saved.Load(cut), UserError) << size;
  }
  ModuleGraph other;
  other.Add(std::make_unique<Keeper>("b"));
  std::istringstream whole(state);
  EXPECT_THROW(other.Load(whole), UserError);
  ModuleGraph larger;
  larger.Add(std::make_unique<Keeper>("a"));
  larger.Add(std::make_unique<Keeper>("c"));
  std::istringstream again(state);
  EXPECT_THROW(larger.Load(again), UserError);
}

// In front, in between and at the end: what is left out need not be there any more.
TEST(ModuleGraphState, ModulesCanBeLeftOut) {
  ModuleGraph saved;
  for (const char* name : {"x", "a", "y", "z", "b", "w"}) {
    saved.Add(std::make_unique<Keeper>(name, name[0]));
  }
  std::stringstream state;
  saved.Save(state);
  ModuleGraph loaded;
  auto& a = static_cast<Keeper&>(loaded.Add(std::make_unique<Keeper>("a")));
  auto& y = static_cast<Keeper&>(loaded.Add(std::make_unique<Keeper>("y")));
  auto& b = static_cast<Keeper&>(loaded.Add(std::make_unique<Keeper>("b")));
  std::istringstream whole(state.str());
  loaded.Load(whole, {"w", "x", "y", "z", "not there"});
  EXPECT_EQ(a.value, 'a');
  EXPECT_EQ(y.value, 'y');  // is there after all
  EXPECT_EQ(b.value, 'b');
  for (const auto& left_out : {std::set<std::string>{"x", "z"}, {"w", "x"}, {}}) {
    std::istringstream again(state.str());
    EXPECT_THROW(loaded.Load(again, left_out), UserError);
  }
}

TEST(ModuleGraphState, AModuleThatItDoesNotKnowStaysAsItIs) {
  ModuleGraph saved;
  saved.Add(std::make_unique<Keeper>("a", '1'));
  saved.Add(std::make_unique<Keeper>("c", '3'));
  std::stringstream state;
  saved.Save(state);
  ModuleGraph loaded;
  for (const char* name : {"a", "b", "c"}) loaded.Add(std::make_unique<Keeper>(name));
  loaded.Load(state, {"b"});
  EXPECT_EQ(static_cast<Keeper&>(loaded.Find("b")).value, '0');
  EXPECT_EQ(static_cast<Keeper&>(loaded.Find("c")).value, '3');
}

class Recorder : public Module {
 public:
  Recorder(std::string name, const Context& context)
      : Module(std::move(name)), seed_(context.seed) {
    AddParameter({"gain", "", &gain_});
  }
  ~Recorder() override { log += "-" + name(); }
  void Start() override { log += "+" + name() + std::to_string(seed_); }

  inline static std::string log;

 private:
  uint64_t seed_;
  double gain_ = 1;
};

TEST(ModuleGraphLife, StartsInTheOrderOfCreationAndDestroysInReverse) {
  Recorder::log.clear();
  ModuleTypes types;
  types.Add<Recorder>("Recorder");
  Context context;
  context.seed = 7;
  {
    ModuleGraph graph;
    graph.Add(types.Make("Recorder", "b", context));
    graph.Add(types.Make("Recorder", "a", context));
    graph.Start();
  }
  EXPECT_EQ(Recorder::log, "+b7+a7-a-b");
}

TEST(ModuleTypes, UnknownTypeGetsTheNearestOne) {
  ModuleTypes types;
  types.Add<Recorder>("Recorder");
  try {
    types.Make("Recoder", "x", Context());
    FAIL();
  } catch (const UserError& error) {
    EXPECT_STREQ(error.what(), "there is no module type `Recoder`: did you mean `Recorder`?");
  }
}

TEST(ConnectSensors, TakesTheSensorOfThisNameAndTypeFromAnyModule) {
  ModuleGraph graph;
  graph.Add(std::make_unique<Source>("anything"));
  Module& sink = graph.Add(std::make_unique<Sink>("sink"));
  ConnectSensors(sink, graph);
  EXPECT_TRUE(static_cast<Sink&>(sink).velocity.connected());
  EXPECT_FALSE(static_cast<Sink&>(sink).position.connected());
  EXPECT_FALSE(static_cast<Sink&>(sink).level.connected());  // no sensor
}

}  // namespace
}  // namespace runtime
