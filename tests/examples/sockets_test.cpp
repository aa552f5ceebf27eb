// Environments over a socket, as docs/environments.md says: the examples of examples/socket.
#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/training/run/run_database.h"
#include "tests/runtime/trainer/child_process.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace examples {
namespace {

using runtime::ChildProcess;
using runtime::ProgramResult;
using runtime::RunProgram;
using testing::HasSubstr;
using testing::MatchesRegex;

constexpr const char* kExamples = SOURCE_DIR "/examples/socket/";
constexpr const char* kPython = "/usr/bin/python3";
constexpr const char* kNode = "/usr/bin/node";

class Sockets : public testing::Test {
 protected:
  std::string Path() const { return (folder_.path() / "s").string(); }
  std::string Run(const char* name) const { return (folder_.path() / name).string(); }

  ProgramResult Train(const std::string& run, int episodes) const {
    return RunProgram({TRAINER, "train", kExamples + std::string("cart_pole.task"),
                       "--environment-socket", Path(), "--episodes", std::to_string(episodes),
                       "--out", run, "--quiet"});
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

TEST_F(Sockets, ACartInPythonIsLearnedWithBitForBit) {
  if (!std::filesystem::exists(kPython)) GTEST_SKIP() << "there is no Python";
  ChildProcess cart({kPython, kExamples + std::string("cart_pole.py"), Path()});
  const ProgramResult whole = Train(Run("whole"), 40);
  ASSERT_EQ(whole.exit_status, 0) << whole.errors;
  ASSERT_EQ(Train(Run("parts"), 25).exit_status, 0);
  const ProgramResult rest =
      RunProgram({TRAINER, "resume", Run("parts"), "--episodes", "40", "--quiet"});
  ASSERT_EQ(rest.exit_status, 0) << rest.errors;
  EXPECT_EQ(Returns(Run("parts")), Returns(Run("whole")));
  cart.Send(SIGTERM);
}

TEST_F(Sockets, WhatIsSavedStaysWhereTheEnvironmentDies) {
  if (!std::filesystem::exists(kPython)) GTEST_SKIP() << "there is no Python";
  const std::vector<std::string> program = {kPython, kExamples + std::string("cart_pole.py"),
                                            Path()};
  {
    ChildProcess cart(program);
    ASSERT_EQ(Train(Run("run"), 5).exit_status, 0);
    ChildProcess trainer({TRAINER, "resume", Run("run"), "--episodes", "100000", "--json"});
    ASSERT_TRUE(trainer.WaitForLines(3));
    cart.Send(SIGKILL);
    const ProgramResult result = trainer.Wait();
    EXPECT_EQ(result.exit_status, 1);
    EXPECT_THAT(result.errors, HasSubstr("has closed the connection in episode "));
    EXPECT_THAT(result.errors, HasSubstr("what was saved is kept, and `trainer resume"));
  }
  EXPECT_GE(Returns(Run("run")).size(), 5u);
  const ChildProcess cart(program);
  const ProgramResult rest =
      RunProgram({TRAINER, "resume", Run("run"), "--episodes", "100", "--quiet"});
  EXPECT_EQ(rest.exit_status, 0) << rest.errors;
  EXPECT_EQ(Returns(Run("run")).size(), 100u);
}

TEST_F(Sockets, WithoutAnEnvironmentAllWaysToOneAreNamed) {
  const ProgramResult result =
      RunProgram({TRAINER, "train", kExamples + std::string("cart_pole.task"), "--out", Run("run"),
                  "--quiet"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("names no robot; name one, for example `--robot humanoid`"));
  EXPECT_THAT(result.errors, HasSubstr("--environment-socket PATH"));
  EXPECT_FALSE(std::filesystem::exists(Run("run")));
}

// `trainer environment` with a client of examples/socket.
class Clients : public Sockets {
 protected:
  Clients()
      : environment_({TRAINER, "environment", SOURCE_DIR "/examples/tasks/swing_up.task",
                      "--profile", "fast-tree", "--socket", Path()}) {}

  ChildProcess environment_;
};

constexpr const char* kImproved = "(.|\n)*from -?[0-9.]+ to -?[0-9.]+\n";

TEST_F(Clients, OneInPythonSearchesByBinaryMessages) {
  if (!std::filesystem::exists(kPython)) GTEST_SKIP() << "there is no Python";
  ASSERT_TRUE(environment_.WaitForLines(1));
  const ProgramResult result =
      RunProgram({kPython, kExamples + std::string("random_search.py"), Path(), "3"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, MatchesRegex(kImproved));
  environment_.Send(SIGTERM);
  EXPECT_EQ(environment_.Wait().exit_status, 0);
}

TEST_F(Clients, OneInJavaScriptSearchesByJson) {
  if (!std::filesystem::exists(kNode)) GTEST_SKIP() << "there is no Node";
  ASSERT_TRUE(environment_.WaitForLines(1));
  const ProgramResult result =
      RunProgram({kNode, kExamples + std::string("random_search.js"), Path(), "3"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, MatchesRegex(kImproved));
}

}  // namespace
}  // namespace examples
