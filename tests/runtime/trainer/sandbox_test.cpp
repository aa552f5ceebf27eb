// What the code of a task can reach: its run's folder, and nothing else.
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "runtime/base/local_socket.h"
#include "runtime/live/server/loopback.h"
#include "tests/runtime/trainer/trainer_test.h"
#include "tests/scoped_environment.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class SandboxTest : public TrainerTest {
 protected:
  SandboxTest() {
    std::filesystem::create_directory(folder() / "home");
    std::ofstream(folder() / "home/secret") << "do not tell";
  }

  std::string Hostile() const { return std::string(PLUGIN_FOLDER) + "/hostile.so"; }
  std::vector<std::string> Words(std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"train",          Hostile(),    "--robot", "humanoid",
                                      "--profile",      "fast",       "--quiet", "--out",
                                      RunFolder("run"), "--episodes", "2"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  // Nothing, as the plugin itself says in each of its attempts.
  static void ExpectNothingWasReached(const ProgramResult& result) {
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    EXPECT_THAT(result.errors,
                AllOf(HasSubstr("hostile load:\n"), Not(HasSubstr("hostile load: "))));
    EXPECT_THAT(result.errors, Not(HasSubstr("hostile step: ")));
  }

  const Descriptor internet_ = ListenOnLoopback(0);
  const LocalListener local_{folder() / "socket"};
  const ScopedEnvironment home_{"HOME", (folder() / "home").string()};
  const ScopedEnvironment cache_{"TASKC_CACHE", (folder() / "cache").string()};
  const ScopedEnvironment port_{"HOSTILE_PORT", std::to_string(PortOf(internet_))};
  const ScopedEnvironment socket_{"HOSTILE_SOCKET", (folder() / "socket").string()};
};

TEST_F(SandboxTest, TheAttemptsSucceedWithoutIt) {
  const ProgramResult result = Trainer(Words({"--no-sandbox"}));
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  const char* all = " read overwrite create remove chmod tcp udp unix signal execute\n";
  EXPECT_THAT(result.errors, HasSubstr(std::string("hostile load:") + all));
}

TEST_F(SandboxTest, ATaskThatIsTrainedReachesNothing) {
  const ProgramResult result = Trainer(Words());
  ExpectNothingWasReached(result);
  EXPECT_THAT(result.errors, HasSubstr("hostile step:\n"));
  EXPECT_TRUE(std::filesystem::exists(folder() / "home/secret"));
}

TEST_F(SandboxTest, NorWhereItsRunIsResumed) {
  ASSERT_EQ(Trainer(Words()).exit_status, 0);
  ExpectNothingWasReached(Trainer({"resume", RunFolder("run"), "--episodes", "4", "--quiet"}));
}

TEST_F(SandboxTest, NorWhereManyRunsAreMade) {
  ExpectNothingWasReached(Trainer(Words({"--runs", "2"})));
}

TEST_F(SandboxTest, NorWhereAStudyMakesThem) {
  std::ofstream(folder() / "study.toml") << "profile = \"fast\"\nepisodes = 2\nseeds = [1]\n"
                                            "robot = \"humanoid\"\n[[experiments]]\ntask = \""
                                         << Hostile() << "\"\n";
  ExpectNothingWasReached(Trainer(
      {"study", (folder() / "study.toml").string(), "--out", RunFolder("study"), "--quiet"}));
}

TEST_F(SandboxTest, NorWhereItsRunIsEvaluatedOrJudgedAnew) {
  ASSERT_EQ(Trainer(Words({"--checkpoint-every", "0"})).exit_status, 0);
  ExpectNothingWasReached(
      Trainer({"evaluate", RunFolder("run"), "--profile", "fast", "--episodes", "2", "--quiet"}));
  ExpectNothingWasReached(Trainer({"rescore", RunFolder("run"), "--task", Hostile()}));
}

TEST_F(SandboxTest, NorWhereItsRunIsReproducedWithItsOwnCode) {
  ASSERT_EQ(Trainer(Words()).exit_status, 0);
  ExpectNothingWasReached(Trainer({"reproduce", RunFolder("run"), "--kept-plugins"}));
}

TEST_F(SandboxTest, NorWhereWhatItsRunHasLearnedIsExported) {
  ASSERT_EQ(Trainer(Words({"--agent", "ppo", "--checkpoint-every", "0"})).exit_status, 0);
  const std::string header = (folder() / "policy.h").string();
  ExpectNothingWasReached(Trainer({"export", RunFolder("run"), "--c-header", header}));
  EXPECT_TRUE(std::filesystem::exists(header));
}

TEST_F(SandboxTest, NorWhereItsAgentIsShown) {
  const ProgramResult result = Trainer({"agent", "show", Hostile(), "--robot", "humanoid"});
  ExpectNothingWasReached(result);
  EXPECT_THAT(result.output, HasSubstr("[modules.learner]"));
}

TEST_F(SandboxTest, NorWhereItIsProbed) {
  const ProgramResult result =
      Trainer({"probe", Hostile(), "--robot", "humanoid", "--searches", "2", "--episodes", "3",
               "--quiet", "--out", RunFolder("probe")});
  ExpectNothingWasReached(result);
  EXPECT_TRUE(std::filesystem::exists(folder() / "probe/probe.html"));
}

class OfferedTest : public SandboxTest {
 protected:
  std::string Socket() const { return (folder() / "offered").string(); }
  std::vector<std::string> Offering() const {
    return {TRAINER, "environment", Hostile(), "--robot", "humanoid", "--socket", Socket()};
  }
};

TEST_F(OfferedTest, NorWhereItIsOfferedAsAnEnvironment) {
  ChildProcess trainer(Offering());
  ASSERT_TRUE(trainer.WaitForLines(1));
  { const LocalSocket client(Socket(), std::chrono::seconds(0)); }
  trainer.Send(SIGTERM);
  ExpectNothingWasReached(trainer.Wait());
  EXPECT_FALSE(std::filesystem::exists(Socket()));
}

TEST_F(OfferedTest, ItsSocketGoesWhenTheTrainerIsKilled) {
  ChildProcess trainer(Offering());
  ASSERT_TRUE(trainer.WaitForLines(1));
  ASSERT_TRUE(std::filesystem::exists(Socket()));
  trainer.Send(SIGKILL);
  EXPECT_EQ(trainer.Wait().signal, SIGKILL);
  for (int tries = 0; tries < 500 && std::filesystem::exists(Socket()); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_FALSE(std::filesystem::exists(Socket()));
}

TEST_F(SandboxTest, AFailedStartLeavesNoFolder) {
  EXPECT_NE(Trainer(Words({"--set", "learner.no_such=1"})).exit_status, 0);
  EXPECT_FALSE(std::filesystem::exists(RunFolder("run")));
}

TEST_F(SandboxTest, NoTemporaryFolderIsLeft) {
  const ScopedEnvironment temporary("TMPDIR", (folder() / "home").string());
  Train("run", 2, {"--quiet"});
  EXPECT_EQ(
      Trainer({"evaluate", RunFolder("run"), "--profile", "fast", "--episodes", "2"}).exit_status,
      0);
  EXPECT_EQ(Trainer({"rescore", RunFolder("run"), "--task", TaskFile("leaning")}).exit_status, 0);
  EXPECT_EQ(Trainer({"reproduce", RunFolder("run")}).exit_status, 0);
  EXPECT_EQ(Trainer({"agent", "show", TaskFile("leaning")}).exit_status, 0);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder() / "home"), {}), 1);
}

}  // namespace
}  // namespace runtime
