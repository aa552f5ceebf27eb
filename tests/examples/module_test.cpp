// A library of modules as a user meets it: examples/module.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "runtime/training/run/run_database.h"
#include "tests/runtime/trainer/child_process.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace examples {
namespace {

using runtime::ProgramResult;
using runtime::RunProgram;
using testing::HasSubstr;

class Modules : public testing::Test {
 protected:
  // An agent file as the example's, with this library beside it.
  std::string AgentWith(const std::filesystem::path& library) {
    const std::filesystem::path agent = folder_.path() / "random_search.agent.toml";
    std::filesystem::copy_file(SOURCE_DIR "/examples/module/random_search.agent.toml", agent,
                               std::filesystem::copy_options::overwrite_existing);
    if (!library.empty()) {
      std::filesystem::copy_file(library, Library(),
                                 std::filesystem::copy_options::overwrite_existing);
    }
    return agent.string();
  }
  std::filesystem::path Library() const { return folder_.path() / "random_search.so"; }
  std::string Run(const char* name) const { return (folder_.path() / name).string(); }

  ProgramResult Train(const std::string& agent, const std::string& run, int episodes) {
    return RunProgram({TRAINER, "train", SOURCE_DIR "/examples/tasks/swing_up.task", "--agent",
                       agent, "--profile", "fast-tree", "--episodes", std::to_string(episodes),
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

TEST_F(Modules, ALearnerFromOutsideLearnsAndResumesBitForBit) {
  const std::string agent = AgentWith(RANDOM_SEARCH);
  const ProgramResult whole = Train(agent, Run("whole"), 40);
  ASSERT_EQ(whole.exit_status, 0) << whole.errors;
  ASSERT_EQ(Train(agent, Run("parts"), 21).exit_status, 0);
  std::filesystem::remove(Library());  // the run has kept it
  const ProgramResult rest =
      RunProgram({TRAINER, "resume", Run("parts"), "--episodes", "40", "--quiet"});
  ASSERT_EQ(rest.exit_status, 0) << rest.errors;
  EXPECT_EQ(Returns(Run("parts")), Returns(Run("whole")));
  EXPECT_EQ(Returns(Run("whole")).size(), 40u);
}

TEST_F(Modules, ItsParametersAreSetLikeAnyOthers) {
  const ProgramResult shown =
      RunProgram({TRAINER, "agent", "show", SOURCE_DIR "/examples/tasks/swing_up.task", "--agent",
                  AgentWith(RANDOM_SEARCH), "--set", "learner.noise=0.25"});
  EXPECT_EQ(shown.exit_status, 0) << shown.errors;
  EXPECT_THAT(shown.output, HasSubstr("type = \"RandomSearch\""));
  EXPECT_THAT(shown.output, HasSubstr("noise = 0.25"));
  EXPECT_THAT(shown.output, HasSubstr("libraries = ["));
}

TEST_F(Modules, WhatDoesNotFitIsRefused) {
  const auto refusal = [this](const std::string& agent) {
    const ProgramResult result = Train(agent, Run("refused"), 1);
    EXPECT_EQ(result.exit_status, 1);
    EXPECT_FALSE(std::filesystem::exists(Run("refused")));
    return result.errors;
  };
  EXPECT_THAT(refusal(AgentWith("")), HasSubstr("random_search.so: there is no such library"));
  EXPECT_THAT(refusal(AgentWith(OLD_MODULES)),
              HasSubstr("has modules for version 0 of the interface"));
  const std::string no_library = AgentWith("");
  std::ofstream(Library()) << "no library";
  EXPECT_THAT(refusal(no_library), HasSubstr("random_search.so: cannot be loaded: "));

  AgentWith(RANDOM_SEARCH);
  std::filesystem::copy_file(RANDOM_SEARCH, folder_.path() / "again.so");
  const std::string both = Run("both.agent.toml");
  std::ofstream(both) << "include = [\"random_search.agent.toml\"]\nwhole = true\n"
                         "libraries = [\"again.so\"]\n";
  EXPECT_THAT(refusal(both), HasSubstr("there is a type of modules `RandomSearch` already"));
}

}  // namespace
}  // namespace examples
