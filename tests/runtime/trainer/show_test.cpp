#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/runtime/run/sample_run.h"
#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class ShowTest : public TrainerTest {
 protected:
  // Two episodes; the first task was swapped for another before the second, and is its shadow.
  void WriteTunedRun() const {
    RunDatabase database = RunDatabase::Create(RunFolder("run"), SampleRun());
    database.AddTask(SampleVersion());
    database.AddChange({0, 2, 0, "2026-01-02T03:04:05Z", "swap", "swap task: b.task", "{}"});
    database.AddChange({0, 2, 40, "2026-01-02T03:04:06Z", "set", "set task.gain = 2", "{}"});
    EpisodeRecord second = SampleEpisode(2);
    second.shadows = {second.active};
    second.active = SampleShadow();
    database.AddEpisode(SampleEpisode(1), {}, {});
    database.AddEpisode(second, {}, {});
  }
};

TEST_F(ShowTest, TellsChangesVersionsAndShadows) {
  WriteTunedRun();
  const std::string output = Trainer({"show", RunFolder("run")}).output;
  EXPECT_THAT(output, AllOf(HasSubstr("version    episodes 1 to 1: crawling (0123abcd)\n"),
                            HasSubstr("version    episodes 2 to 2: crawling (4567cdef)\n"),
                            HasSubstr("shadow     task, crawling (0123abcd): 0.2 on average"),
                            HasSubstr("change     episode 2: swap task: b.task\n"),
                            HasSubstr("change     episode 2, step 40: set task.gain = 2\n")));
  EXPECT_THAT(output, HasSubstr("distance: 0.75 m on average"));  // of the active task's episode
  const auto json = nlohmann::json::parse(Trainer({"show", RunFolder("run"), "--json"}).output);
  EXPECT_EQ(json["versions"].size(), 2u);
  EXPECT_EQ(json["versions"][1]["first_episode"], 2);
  EXPECT_EQ(json["shadows"]["task"]["last_return"], 0.2);
  EXPECT_EQ(json["changes"][1]["step"], 40);
}

TEST_F(ShowTest, TellsWhatTheLearnerShowedLast) {
  {
    RunDatabase database = RunDatabase::Create(RunFolder("run"), SampleRun());
    database.SetLearnerCurves({{"rate", "", "", ""}});
    for (int64_t number = 1; number <= 2; ++number) {
      EpisodeRecord episode = SampleEpisode(number);
      episode.learner = {{"rate", 0.5 / static_cast<double>(number)}};
      database.AddEpisode(episode, {}, {});
    }
  }
  EXPECT_THAT(Trainer({"show", RunFolder("run")}).output,
              HasSubstr("learner    rate: 0.25 in the last episode\n"));
  const auto json = nlohmann::json::parse(Trainer({"show", RunFolder("run"), "--json"}).output);
  EXPECT_EQ(json["learner"], (nlohmann::json{{"rate", 0.25}}));
}

TEST_F(ShowTest, SaysNothingOfThemWhereThereAreNone) {
  RunDatabase::Create(RunFolder("run"), SampleRun()).AddEpisode(SampleEpisode(1), {}, {});
  const std::string output = Trainer({"show", RunFolder("run")}).output;
  EXPECT_THAT(output, AllOf(HasSubstr("task       crawling (tasks/crawling.task)\n"),
                            Not(HasSubstr("version")), Not(HasSubstr("shadow")),
                            Not(HasSubstr("change")), Not(HasSubstr("learner "))));
}

}  // namespace
}  // namespace runtime
