// How requests reach the run, with all that is prepared for them.
#include <cstdlib>

#include "tests/runtime/live/control/live_run_test.h"

namespace runtime {
namespace {

json ExampleOf(const ArgumentSpec& argument) {
  switch (argument.type) {
    case ArgumentType::kText:
      return "task";
    case ArgumentType::kTaskFile:
      return PluginFile("other").string();
    case ArgumentType::kWhole:
      return 3;
    case ArgumentType::kNumber:
    case ArgumentType::kValue:
      return 0.5;
    case ArgumentType::kFlag:
      return true;
    case ArgumentType::kObject:
      return {{"count", 2}};
  }
  return nullptr;
}

TEST_F(LiveRunTest, EveryCommandIsAnswered) {
  Trainer& run = Begin(100);
  std::vector<std::pair<std::string, std::future<Reply>>> replies;
  for (const CommandSpec& command : Commands()) {
    json arguments = json::object();
    for (const ArgumentSpec& argument : command.arguments) {
      arguments[argument.name] = ExampleOf(argument);
    }
    replies.emplace_back(command.name, run.Send(command.name, arguments));
  }
  trainer_.reset();
  for (auto& [command, future] : replies) {
    ASSERT_EQ(future.wait_for(std::chrono::seconds(0)), std::future_status::ready) << command;
    const Reply reply = future.get();
    EXPECT_EQ(reply.ok, reply.error.empty()) << command << ": " << reply.error;
  }
}

// How often the plugin `counted` was loaded in this process.
int Loads() {
  const char* const loads = std::getenv("COUNTED_LOADS");
  return loads == nullptr ? 0 : std::atoi(loads);
}

class LoadsTest : public LiveRunTest {
 protected:
  void SetUp() override { unsetenv("COUNTED_LOADS"); }
};

TEST_F(LoadsTest, ATaskIsLoadedOnceForEachRequest) {
  Trainer& run = Begin(100);
  run.Run(5, "step");
  run.Ask("swap", Swap("counted", true));
  EXPECT_EQ(Loads(), 1);
  run.Ask("load", {{"file", PluginFile("counted").string()}, {"name", "shadow"}});
  EXPECT_EQ(Loads(), 2);
  EXPECT_EQ(run.Ask("swap", Swap("counted", true))["takes_effect"], "already");
  EXPECT_EQ(Loads(), 3);
}

TEST_F(LoadsTest, ATaskThatTakesEffectLaterWaitsLoaded) {
  Trainer& run = Begin(100);
  run.Run(5, "step");
  EXPECT_EQ(run.Ask("swap", Swap("counted", false))["takes_effect"], "episode 2");
  run.Ask("swap", Swap("steady", false));
  EXPECT_EQ(run.Ask("swap", Swap("counted", false))["takes_effect"], "episode 2");
  EXPECT_EQ(Loads(), 2);
  run.Run(2, "episode");
  EXPECT_EQ(run.Ask("list")["tasks"][0]["task"], "counted");
  EXPECT_EQ(Loads(), 2);
}

TEST_F(LoadsTest, ARollbackLoadsWhatIsNotLoaded) {
  Trainer& run = Begin(100);
  for (const char* plugin : {"counted", "other", "steady"}) run.Ask("swap", Swap(plugin, true));
  EXPECT_EQ(Loads(), 1);
  run.Ask("rollback", {{"name", "task"}, {"version", "2"}, {"now", true}});
  EXPECT_EQ(Loads(), 2);
  run.Ask("rollback", {{"name", "task"}, {"now", true}});
  run.Ask("rollback", {{"name", "task"}, {"now", true}});
  EXPECT_EQ(run.Ask("list")["tasks"][0]["task"], "counted");
  EXPECT_EQ(Loads(), 2);
}

TEST_F(LoadsTest, ARunThatGoesOnLoadsWhatItHasKept) {
  Begin(100).Ask("swap", Swap("counted", true));
  trainer_->Run(1, "episode");
  Kill();
  EXPECT_EQ(Loads(), 1);
  EXPECT_EQ(Begin(100).Ask("list")["tasks"][0]["task"], "counted");
  EXPECT_EQ(Loads(), 2);
}

}  // namespace
}  // namespace runtime
