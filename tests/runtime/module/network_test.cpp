#include "runtime/module/network.h"

#include <gmock/gmock.h>

#include "runtime/module/context.h"
#include "tests/runtime/module/test_modules.h"

namespace runtime {
namespace {

using testing::ElementsAre;

class NetworkTest : public testing::Test {
 protected:
  NetworkTest() {
    network_.Add(std::make_unique<Source>("environment"));
    network_.Add(std::make_unique<Sink>("task"));
  }

  static std::string MessageOf(const std::function<void()>& action) {
    try {
      action();
    } catch (const UserError& error) {
      return error.what();
    }
    return "no error";
  }

  Source& source() { return network_.FindAs<Source>("environment"); }
  Sink& sink() { return network_.FindAs<Sink>("task"); }

  Network network_;
};

TEST_F(NetworkTest, ConnectsByName) {
  network_.Connect("environment.reward", "task.reward");
  network_.Connect("task.level", "environment.level");
  network_.Connect("environment.base.velocity", "task.base.velocity");
  source().reward(3);
  EXPECT_THAT(sink().received, ElementsAre(3));
  EXPECT_EQ(sink().level(), 2.5);
  EXPECT_EQ(&sink().velocity(), &source().velocity_data);
}

TEST_F(NetworkTest, DisconnectsByName) {
  network_.Connect("environment.reward", "task.reward");
  network_.Disconnect("task.reward", "environment.reward");
  source().reward(3);
  EXPECT_TRUE(sink().received.empty());
}

TEST_F(NetworkTest, StarConnectsEachInPortThatHasNoConnectionToTheOutPortOfItsName) {
  network_.Connect("environment.still", "task.level");
  network_.Connect("environment.*", "task.*");
  EXPECT_EQ(&sink().level(), &source().level_value);
  EXPECT_EQ(source().refreshes, 0);
  EXPECT_TRUE(sink().velocity.connected());
  EXPECT_FALSE(sink().position.connected());
  EXPECT_TRUE(source().reward.Connections().empty());
}

TEST_F(NetworkTest, StarOnOneSideOnlyIsRefused) {
  EXPECT_EQ(
      MessageOf([&] { network_.Connect("environment.*", "task.level"); }),
      "cannot connect `environment.*` to `task.level`: `*` stands for all ports on both sides or "
      "on none");
}

TEST_F(NetworkTest, UnknownNamesGetTheNearestOne) {
  EXPECT_EQ(MessageOf([&] { network_.Connect("enviroment.reward", "task.reward"); }),
            "there is no module `enviroment`: did you mean `environment`?");
  EXPECT_EQ(MessageOf([&] { network_.Connect("environment.rewrad", "task.reward"); }),
            "the module `environment` has no port `rewrad`: did you mean `reward`?");
  EXPECT_EQ(MessageOf([&] { network_.Find("x"); }),
            "there is no module `x`; there are `environment`, `task`");
  EXPECT_EQ(MessageOf([&] { network_.FindPort("environment"); }),
            "`environment` is no port: write MODULE.PORT");
}

TEST_F(NetworkTest, TypesThatDifferAreRefusedWithThePortsThatWouldFit) {
  EXPECT_EQ(MessageOf([&] { network_.Connect("environment.reward", "task.end"); }),
            "cannot connect `environment.reward` to `task.end`: the types differ: "
            "`environment.reward` is `(real)`, `task.end` is `(episode end)`; "
            "`environment.reward` fits `task.reward`");
  EXPECT_EQ(MessageOf([&] { network_.Connect("environment.level", "task.base.position"); }),
            "cannot connect `environment.level` to `task.base.position`: the types differ: "
            "`environment.level` is `real`, `task.base.position` is `vec3 [m]`; "
            "`environment.level` fits `task.level`");
}

TEST_F(NetworkTest, NamesOfModulesAreUniqueAndHaveNoDot) {
  EXPECT_EQ(MessageOf([&] { network_.Add(std::make_unique<Sink>("task")); }),
            "there is a module `task` already");
  EXPECT_EQ(MessageOf([&] { network_.Add(std::make_unique<Sink>("a.b")); }),
            "`a.b` cannot name a module: a name has no '.'");
}

TEST_F(NetworkTest, ModuleOfAnotherClassIsRefused) {
  EXPECT_THROW(network_.FindAs<Sink>("environment"), UserError);
}

TEST_F(NetworkTest, TextListsModulesAndConnections) {
  network_.Connect("environment.reward", "task.reward");
  network_.Connect("environment.*", "task.*");
  EXPECT_EQ(network_.ToText(),
            "environment\n"
            "  reward -> task.reward  (real)\n"
            "  level -> task.level  real\n"
            "  base.velocity -> task.base.velocity  vec3 [m/s]\n"
            "task\n");
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

TEST(NetworkLife, StartsInTheOrderOfCreationAndDestroysInReverse) {
  Recorder::log.clear();
  ModuleTypes types;
  types.Add<Recorder>("Recorder");
  Context context;
  context.seed = 7;
  {
    Network network;
    network.Add(types.Make("Recorder", "b", context));
    network.Add(types.Make("Recorder", "a", context));
    network.Start();
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

}  // namespace
}  // namespace runtime
