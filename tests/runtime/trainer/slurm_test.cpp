// Studies that are given to a cluster. Here its programs are scripts; tests/slurm/study.sh has a
// real one.
#include <fstream>
#include <nlohmann/json.hpp>

#include "runtime/trainer/engines/slurm_engine.h"
#include "runtime/trainer/engines/slurm_queue.h"
#include "tests/runtime/trainer/trainer_test.h"
#include "tests/scoped_environment.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::vector<SlurmArray> kArrays = {{34, {"a/seed1", "a/seed2", "b/seed1"}},
                                         {50, {"a/seed1"}}};

TEST(SlurmQueue, KnowsTheRunsOfTasks) {
  const SlurmTasks tasks = ParseQueue(
      "34|0|RUNNING|n1|None\n34|2|PENDING||Resources\n34|7|RUNNING|n1|None\n99|0|RUNNING|n2|None\n"
      "nonsense\n51|N/A|RUNNING|n1|None\n",
      kArrays);
  ASSERT_EQ(tasks.size(), 2u);
  EXPECT_EQ(tasks.at("a/seed1").node, "n1");
  EXPECT_EQ(tasks.at("b/seed1").state, "PENDING");
  EXPECT_EQ(tasks.at("b/seed1").reason, "Resources");
}

TEST(SlurmQueue, KnowsHowTheyEnded) {
  const SlurmTasks tasks = ParseAccounts(
      "34_0|NODE_FAIL|n1\n34_1|COMPLETED|n2\n34_[2]|PENDING|None "
      "assigned\n50_0|TIMEOUT|n2\n12|X|\n",
      kArrays);
  ASSERT_EQ(tasks.size(), 2u);
  EXPECT_EQ(tasks.at("a/seed1").state, "TIMEOUT");  // of its last task
  EXPECT_EQ(tasks.at("a/seed2").state, "COMPLETED");
}

TEST(SlurmScript, QuotesWhatItIsMadeOf) {
  EXPECT_THAT(SlurmScript("/opt/a b/trainer", "/it's/runs-1.txt", {.modules = {"gcc/12"}}),
              AllOf(HasSubstr("'/opt/a b/trainer' resume \"$run\" --quiet"),
                    HasSubstr("'/it'\\''s/runs-1.txt'"), HasSubstr("module load 'gcc/12'")));
}

class SlurmTest : public TrainerTest {
 protected:
  SlurmTest() : path_("PATH", (folder() / "bin").string() + ":" + getenv("PATH")) {
    std::filesystem::create_directory(folder() / "bin");
    Program("sbatch", "echo \"$@\" >>" + RunFolder("calls") + "; echo 34");
    Program("squeue", "cat " + RunFolder("queue") + " 2>/dev/null; true");
    Program("sacct", "exit 1");
    std::ofstream(folder() / "study.toml")
        << "profile = 'fast'\nepisodes = 2\nseeds = [1, 2]\n[[experiments]]\ntask = '"
        << TaskFile("leaning") << "'\n[slurm]\npartition = 'cpu'\ntime = '1:00'\nat_once = 5\n";
  }

  void Program(const std::string& name, const std::string& script) const {
    const std::filesystem::path file = folder() / "bin" / name;
    std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  void Queue(const std::string& text) const { std::ofstream(folder() / "queue") << text; }
  ProgramResult Study(std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"study",    (folder() / "study.toml").string(),
                                      "--out",    RunFolder("study"),
                                      "--engine", "slurm"};
    words.insert(words.end(), more.begin(), more.end());
    return Trainer(std::move(words));
  }
  json Status() const {
    const ProgramResult result = Trainer({"study", "status", RunFolder("study"), "--json"});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return json::parse(result.output);
  }

 private:
  ScopedEnvironment path_;
};

TEST_F(SlurmTest, SubmitsWhatIsNotFinishedAndNotInTheQueue) {
  ProgramResult result = Study({"--memory", "2G", "--sbatch", "--nice=5"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("2 runs submitted as job 34"));
  std::string calls;
  std::getline(std::ifstream(folder() / "calls"), calls);
  EXPECT_THAT(calls, AllOf(HasSubstr("--requeue"), HasSubstr("--array=0-1%5"),
                           HasSubstr("--partition=cpu --time=1:00 --mem=2G --nice=5")));

  Queue("34|0|RUNNING|n1|None\n34|1|PENDING||Resources\n");
  EXPECT_THAT(Study().output,
              AllOf(HasSubstr("2 in the queue already"), Not(HasSubstr("submitted"))));
  EXPECT_EQ(Status()[0]["state"], "running");
  EXPECT_EQ(Status()[1]["task"]["reason"], "Resources");

  // What the task of the array does on its node.
  const ScopedEnvironment job("SLURM_ARRAY_JOB_ID", "34");
  const ScopedEnvironment index("SLURM_ARRAY_TASK_ID", "1");
  result = RunProgram({"/bin/bash", (folder() / "study" / "slurm" / "job-1.sh").string()});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  Queue("");
  EXPECT_EQ(Status()[0]["state"], "waiting");
  EXPECT_EQ(Status()[1]["state"], "finished");
  EXPECT_THAT(Study().output, AllOf(HasSubstr("1 run submitted"), HasSubstr("1 finished")));
}

TEST_F(SlurmTest, SaysWhatIsWrong) {
  Program("sbatch", "echo 'sbatch: error: invalid partition' >&2; exit 1");
  ProgramResult result = Study();
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, AllOf(HasSubstr("invalid partition"), HasSubstr("has refused")));
  EXPECT_EQ(Trainer({"study", "status"}).exit_status, 2);
  EXPECT_EQ(Trainer({"study", "status", RunFolder("none")}).exit_status, 1);
  std::ofstream(folder() / "study.toml", std::ios::app) << "partitoin = 'x'\n";
  EXPECT_THAT(Study().errors, HasSubstr("[slurm] has no `partitoin`: did you mean `partition`?"));
}

}  // namespace
}  // namespace runtime
