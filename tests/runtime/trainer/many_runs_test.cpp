#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class ManyRunsTest : public TrainerTest {
 protected:
  ProgramResult TrainMany(const std::string& name, int runs, int episodes,
                          std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--runs", std::to_string(runs), "--jobs", "2", "--seed", "3"});
    return Trainer(Training(name, episodes, std::move(more)));
  }
  std::vector<std::string> ManyWords(const std::string& name, int episodes) const {
    return Training(name, episodes,
                    {"--runs", "2", "--jobs", "2", "--seed", "3", "--checkpoint-every", "0"});
  }
  RunState StateOf(const std::string& run) const {
    return RunDatabase::OpenToRead(RunFolder(run)).ReadState();
  }
  size_t EpisodesOf(const std::string& run) const {
    return RunDatabase::OpenToRead(RunFolder(run)).ReadEpisodes().size();
  }
};

// The process ids of the workers of `supervisor`, from the kernel's own list.
std::vector<pid_t> WorkersOf(pid_t supervisor) {
  std::vector<pid_t> workers;
  std::ifstream list("/proc/" + std::to_string(supervisor) + "/task/" + std::to_string(supervisor) +
                     "/children");
  for (pid_t worker; list >> worker;) workers.push_back(worker);
  return workers;
}

TEST_F(ManyRunsTest, EachIsWhatItWouldBeAlone) {
  const ProgramResult result = TrainMany("many", 3, 3);
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  for (const char* seed : {"3", "4", "5"}) {
    Train(std::string("alone") + seed, 3, {"--seed", seed, "--quiet"});
    ExpectEqual(TraceOf(std::string("many/seed") + seed), TraceOf(std::string("alone") + seed));
    EXPECT_EQ(StateOf(std::string("many/seed") + seed), RunState::kFinished);
  }
}

TEST_F(ManyRunsTest, EndsWithOneTableOfAllRuns) {
  const ProgramResult result = TrainMany("many", 2, 2);
  EXPECT_THAT(result.output, HasSubstr("\nrun       state        episodes       last"));
  EXPECT_THAT(result.output, HasSubstr("\nseed3     finished          2/2 "));
  EXPECT_THAT(result.output, HasSubstr("\n2 finished   4/4 episodes\n"));
  EXPECT_THAT(result.output, Not(HasSubstr("\x1b")));
}

TEST_F(ManyRunsTest, ShowTellsOfAllRunsOfAFolder) {
  ASSERT_EQ(TrainMany("many", 2, 2, {"--quiet"}).exit_status, 0);
  const ProgramResult text = Trainer({"show", RunFolder("many")});
  EXPECT_THAT(text.output, HasSubstr("\nseed4     finished          2/2 "));
  EXPECT_THAT(text.output, HasSubstr("\n2 finished   4/4 episodes\n"));
  const auto said = nlohmann::json::parse(Trainer({"show", RunFolder("many"), "--json"}).output);
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(said[1]["run"], "seed4");
  EXPECT_EQ(said[1]["episodes"], 2);
}

TEST_F(ManyRunsTest, JsonNamesTheRunOfEachEpisode) {
  const ProgramResult result = TrainMany("many", 2, 2, {"--json"});
  std::map<std::string, int> episodes;
  std::istringstream lines(result.output);
  for (std::string line; std::getline(lines, line);) {
    const auto said = nlohmann::json::parse(line);
    EXPECT_EQ(said["episode"], ++episodes[said["run"]]);
  }
  EXPECT_EQ(episodes, (std::map<std::string, int>{{"seed3", 2}, {"seed4", 2}}));
}

TEST_F(ManyRunsTest, AKilledWorkerIsStartedAgainAndNothingIsLost) {
  Train("alone", 12, {"--seed", "3", "--quiet"});
  ChildProcess supervisor([&] {
    std::vector<std::string> words = ManyWords("many", 12);
    words.insert(words.begin(), TRAINER);
    words.push_back("--json");
    return words;
  }());
  ASSERT_TRUE(supervisor.WaitForLines(4));
  const std::vector<pid_t> workers = WorkersOf(supervisor.process());
  ASSERT_FALSE(workers.empty());
  kill(workers.front(), SIGKILL);
  const ProgramResult result = supervisor.Wait();
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("its worker ended by signal 9"));
  ExpectEqual(TraceOf("many/seed3"), TraceOf("alone"));
}

TEST_F(ManyRunsTest, CtrlCStopsAllAndResumeGoesOnWithAll) {
  Train("alone", 12, {"--seed", "4", "--quiet"});
  ChildProcess supervisor([&] {
    std::vector<std::string> words = ManyWords("many", 12);
    words.insert(words.begin(), TRAINER);
    words.push_back("--json");
    return words;
  }());
  ASSERT_TRUE(supervisor.WaitForLines(3));
  supervisor.Send(SIGINT);
  EXPECT_EQ(supervisor.Wait().exit_status, 128 + SIGINT);
  EXPECT_EQ(StateOf("many/seed4"), RunState::kInterrupted);
  EXPECT_LT(EpisodesOf("many/seed4"), 12u);
  const ProgramResult resumed = Trainer({"resume", RunFolder("many"), "--quiet"});
  EXPECT_EQ(resumed.exit_status, 0) << resumed.errors;
  EXPECT_EQ(resumed.output, "");
  ExpectEqual(TraceOf("many/seed4"), TraceOf("alone"));
}

TEST_F(ManyRunsTest, ARunThatCannotGoOnIsGivenUpAndTheOthersFinish) {
  ASSERT_EQ(TrainMany("many", 2, 1).exit_status, 0);
  for (const auto& entry : std::filesystem::directory_iterator(RunFolder("many/seed3"))) {
    if (entry.path().extension() == ".so") std::filesystem::remove(entry.path());
  }
  const ProgramResult result = Trainer({"resume", RunFolder("many"), "--episodes", "3"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("seed3: given up: trainer: error: "));
  EXPECT_EQ(EpisodesOf("many/seed4"), 3u);
  EXPECT_THAT(result.output, HasSubstr("seed3     failed            1/3 "));
}

TEST_F(ManyRunsTest, ARunThatWasNeverFinishedBeingMadeIsNotInTheWayOfTheOthers) {
  ASSERT_EQ(TrainMany("many", 2, 1).exit_status, 0);
  const std::filesystem::path half = folder() / "many" / "seed5";
  int episodes = 1;
  for (const char* name : {"plugin-0123456789abcdef.so.77.part", "plugin-0123456789abcdef.so",
                           "run.db.part", "run.db"}) {
    std::filesystem::remove_all(half);
    std::filesystem::create_directory(half);
    std::ofstream(half / name).close();
    const auto warning = HasSubstr("warning: " + half.string() + ": not a run: ");
    const ProgramResult shown = Trainer({"show", RunFolder("many")});
    EXPECT_EQ(shown.exit_status, 0);
    EXPECT_THAT(shown.output, HasSubstr("\n2 finished   "));
    EXPECT_THAT(shown.errors, warning) << name;
    const ProgramResult resumed =
        Trainer({"resume", RunFolder("many"), "--episodes", std::to_string(++episodes)});
    EXPECT_EQ(resumed.exit_status, 0);
    EXPECT_THAT(resumed.errors, warning) << name;
  }
  EXPECT_EQ(EpisodesOf("many/seed4"), 5u);
  Train("many/seed5", 1, {"--seed", "5", "--quiet"});  // as the warning says
  EXPECT_EQ(Trainer({"show", RunFolder("many")}).errors, "");
}

TEST_F(ManyRunsTest, NorIsOneThatCannotBeRead) {
  ASSERT_EQ(TrainMany("many", 2, 1).exit_status, 0);
  std::ofstream(folder() / "many" / "seed3" / "run.db") << std::string(5000, 'x');
  const ProgramResult shown = Trainer({"show", RunFolder("many")});
  EXPECT_EQ(shown.exit_status, 1);
  EXPECT_THAT(shown.errors, HasSubstr("seed3/run.db: cannot open the run: the file is damaged"));
  EXPECT_THAT(shown.output, HasSubstr("\n1 finished, 1 failed   "));
  const ProgramResult resumed = Trainer({"resume", RunFolder("many"), "--episodes", "3"});
  EXPECT_EQ(resumed.exit_status, 1);
  EXPECT_THAT(resumed.errors, HasSubstr("seed3/run.db: cannot open the run: the file is damaged"));
  EXPECT_EQ(EpisodesOf("many/seed4"), 3u);
}

TEST_F(ManyRunsTest, MoreRunsAreAddedToThoseThatAreThere) {
  ASSERT_EQ(TrainMany("many", 2, 1).exit_status, 0);
  const ProgramResult repeated = TrainMany("many", 2, 1);
  EXPECT_EQ(repeated.exit_status, 1);
  EXPECT_THAT(repeated.errors, HasSubstr("seed3"));
  const ProgramResult more = Trainer(Training("many", 1, {"--runs", "2", "--seed", "5"}));
  EXPECT_EQ(more.exit_status, 0) << more.errors;
  EXPECT_THAT(more.output, HasSubstr("4 finished   4/4 episodes"));
}

}  // namespace
}  // namespace runtime
