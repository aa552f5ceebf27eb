#include <fstream>
#include <nlohmann/json.hpp>

#include "runtime/training/run/sqlite.h"
#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

class RescoreTest : public TrainerTest {
 protected:
  json Rescore(const std::string& name, const std::string& task) const {
    const ProgramResult result = Trainer({"rescore", RunFolder(name), "--task", task, "--json"});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return json::parse(result.output);
  }
};

// To the bit: what was recorded of each term, and what both tasks say of it now. A learner adds up
// the return by action, which may be another number in its last digits.
TEST_F(RescoreTest, SaysTheSameOfTheSameTask) {
  Train("run", 6, {"--record-every", "1"});
  const json run = Rescore("run", TaskFile("leaning"))["runs"][0];
  ASSERT_THAT(run["episodes"], SizeIs(6));
  const RunDatabase database = RunDatabase::OpenToRead(RunFolder("run"));
  const std::vector<TermRecord> terms = database.ReadRun().tasks.front().terms;
  const std::vector<EpisodeRecord> episodes = database.ReadEpisodes();
  for (size_t i = 0; i < episodes.size(); ++i) {
    const json& episode = run["episodes"][i];
    const Evaluation& recorded = episodes[i].active;
    EXPECT_EQ(episode["old"], episode["new"]);
    EXPECT_EQ(episode["recorded_return"], recorded.episode_return);
    EXPECT_NEAR(episode["new"]["return"], recorded.episode_return, 1e-9);
    for (size_t term = 0; term < terms.size(); ++term)
      EXPECT_EQ(episode["new"]["terms"][terms[term].name], recorded.terms[term]) << "episode " << i;
    EXPECT_EQ(episode["new"]["end_kind"], recorded.end_kind);
    EXPECT_EQ(episode["new"]["end_reason"], recorded.end_reason);
    EXPECT_TRUE(episode["first_difference"].is_null());
  }
}

// With another learner, whose episodes end in the middle of actions, and several at a time.
TEST_F(RescoreTest, SaysTheSameOfTheSameTaskWithOtherLearnersToo) {
  for (const char* agent : {"ppo", "motion_search"}) {
    Train(agent, 4, {"--record-every", "1", "--agent", agent, "--jobs", "2"});
    const json run = Rescore(agent, TaskFile("leaning"))["runs"][0];
    ASSERT_THAT(run["episodes"], SizeIs(4)) << agent;
    for (const json& episode : run["episodes"])
      EXPECT_NEAR(episode["new"]["return"], episode["recorded_return"], 1e-9) << agent;
  }
}

TEST_F(RescoreTest, SaysWhereAnotherTaskFirstDiffers) {
  Train("run", 3, {"--record-every", "1"});
  const std::string file = RunFolder("height.task");
  std::ofstream(file) << "task height for humanoid\nstart standing\n"
                         "on end_of_time_step {\n"
                         "  reward rate up = base.position.z / 1 m\n"
                         "  if time > 0.1 s { truncate_episode \"early\" }\n}\n";
  const json episode = Rescore("run", file)["runs"][0]["episodes"][0];
  EXPECT_EQ(episode["new"]["end_reason"], "early");
  EXPECT_GT(episode["new"]["terms"]["up"], 0);
  EXPECT_NEAR(episode["first_difference"]["time"], 0.005, 1e-9);
}

TEST_F(RescoreTest, JudgesOneEpisodeAlone) {
  Train("run", 4, {"--record-every", "2"});
  const std::vector<std::string> words = {"rescore",           RunFolder("run"), "--task",
                                          TaskFile("leaning"), "--json",         "--episode"};
  const auto judge = [&](const std::string& episode) {
    std::vector<std::string> all = words;
    all.push_back(episode);
    return Trainer(std::move(all));
  };
  const json run = json::parse(judge("2").output)["runs"][0];
  ASSERT_THAT(run["episodes"], SizeIs(1));
  EXPECT_EQ(run["episodes"][0]["episode"], 2);
  EXPECT_EQ(run["episodes"][0]["old"], run["episodes"][0]["new"]);
  const ProgramResult wrong = judge("9");
  EXPECT_EQ(wrong.exit_status, 1);
  EXPECT_THAT(wrong.errors, HasSubstr("episode 9 is not recorded"));
}

TEST_F(RescoreTest, PutsRunsInOrder) {
  for (const char* seed : {"1", "2", "3"})
    Train(std::string("runs/seed") + seed, 3, {"--record-every", "1", "--seed", seed});
  const ProgramResult result =
      Trainer({"rescore", RunFolder("runs"), "--task", TaskFile("leaning")});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, AllOf(HasSubstr("seed1 (leaning, fast)"),
                                   HasSubstr("order of the runs: Spearman "
                                             "1.000, Kendall 1.000"),
                                   HasSubstr("note: the behavior was learned for the old task")));
}

TEST_F(RescoreTest, RefusesRunsThatWereRecordedWithoutTapes) {
  Train("run", 2);
  SqliteDatabase(RunFolder("run") + "/run.db", SqliteAccess::kWrite).Execute("DROP TABLE tape", "");
  const ProgramResult result =
      Trainer({"rescore", RunFolder("run"), "--task", TaskFile("leaning")});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("none of its recorded episodes was recorded with what it "
                                       "was driven by"));
}

TEST_F(RescoreTest, RefusesATaskForAnotherRobotOrWithErrors) {
  Train("run", 1);
  const std::string file = RunFolder("other.task");
  std::ofstream(file) << "task other for rover\non end_of_time_step {\n"
                         "  if time > 1 s { truncate_episode \"late\" }\n}\n";
  ProgramResult result = Trainer({"rescore", RunFolder("run"), "--task", file});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("rover"));
  result = Trainer({"rescore", RunFolder("run"), "--task", TaskFile("wrong")});
  EXPECT_EQ(result.exit_status, 1);
  result = Trainer({"rescore", RunFolder("absent"), "--task", TaskFile("leaning")});
  EXPECT_EQ(result.exit_status, 1);
}

}  // namespace
}  // namespace runtime
