// Runs in a world, and runs in which something is random.
#include <filesystem>
#include <fstream>
#include <set>

#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class WorldRunTest : public TrainerTest {
 protected:
  void SetUp() override {
    Write("push.task",
          "task push for humanoid in \"yard.toml\"\n"
          "observe ball.position - base.position\n"
          "metric distance = ball.position.x\n"
          "on end_of_time_step {\n"
          "  reward rate way = ball.velocity.x / 1 m\n"
          "  if time > 0.3 s { truncate_episode \"time is up\" }\n}\n");
    Write("yard.toml",
          "[ground]\nkind = \"heightmap\"\nfile = \"hills.csv\"\nsize = [4, 4]\n"
          "[[things]]\nname = \"ball\"\nshape = \"sphere\"\nradius = 0.03\nmass = 0.03\n"
          "position = [0.1, 0]\n");
    Write("hills.csv", "0, 0, 0.1\n0, 0, 0\n0, 0, 0.1\n");
  }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder() / name) << text;
  }

  std::vector<std::string> TrainPush(const std::string& name, int episodes,
                                     std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"train",        (folder() / "push.task").string(),
                                      "--profile",    "fast-tree",
                                      "--episodes",   std::to_string(episodes),
                                      "--agent",      "ppo",
                                      "--quiet",      "--out",
                                      RunFolder(name)};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

TEST_F(WorldRunTest, GoesOnWithoutTheFilesOfItsWorld) {
  ASSERT_EQ(Trainer(TrainPush("whole", 6)).exit_status, 0);
  const ProgramResult part = Trainer(TrainPush("part", 3));
  ASSERT_EQ(part.exit_status, 0) << part.errors;
  for (const char* file : {"push.task", "yard.toml", "hills.csv"}) fs::remove(folder() / file);
  const ProgramResult resumed =
      Trainer({"resume", RunFolder("part"), "--episodes", "6", "--quiet"});
  ASSERT_EQ(resumed.exit_status, 0) << resumed.errors;
  ExpectEqual(TraceOf("part"), TraceOf("whole"));
  const ProgramResult evaluated =
      Trainer({"evaluate", RunFolder("part"), "--profile", "paper", "--episodes", "1"});
  EXPECT_EQ(evaluated.exit_status, 0) << evaluated.errors;
  const RunRecord run = RunDatabase::OpenToRead(RunFolder("part")).ReadRun();
  EXPECT_THAT(run.body, HasSubstr("\"name\":\"ball\""));
  EXPECT_THAT(run.body, HasSubstr("\"thing\":true"));
  EXPECT_EQ(run.tasks.at(0).sources.size(), 3u);
}

TEST_F(WorldRunTest, IsDrawnWithItsThings) {
  ASSERT_EQ(Trainer(TrainPush("run", 2)).exit_status, 0);
  const std::string picture = (folder() / "run.png").string();
  const ProgramResult drawn = Trainer({"snapshots", RunFolder("run"), "-o", picture});
  EXPECT_EQ(drawn.exit_status, 0) << drawn.errors;
  EXPECT_GT(fs::file_size(picture), 1000u);
}

TEST_F(WorldRunTest, RandomizedGoesOnBitForBitWithAnyNumberOfCollectors) {
  const std::vector<std::string> random = {"--set", "environment.random_mass=[0.8, 1.2]",
                                           "--set", "environment.random_friction=[0.4, 1.0]",
                                           "--set", "environment.random_delay=[0, 0.02]",
                                           "--set", "environment.push_speed=0.5",
                                           "--set", "environment.push_interval=[0.05, 0.2]",
                                           "--set", "environment.rate_noise=0.1"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), random.begin(), random.end());
    return more;
  };
  const ProgramResult one = Trainer(TrainPush("one", 6, with({"--jobs", "1"})));
  ASSERT_EQ(one.exit_status, 0) << one.errors;
  ASSERT_EQ(Trainer(TrainPush("two", 3, with({"--jobs", "2"}))).exit_status, 0);
  ASSERT_EQ(Trainer({"resume", RunFolder("two"), "--episodes", "6", "--quiet"}).exit_status, 0);
  ExpectEqual(TraceOf("two"), TraceOf("one"));
  std::set<double> masses;
  for (const EpisodeRecord& episode : RunDatabase::OpenToRead(RunFolder("one")).ReadEpisodes()) {
    for (const NamedValue& value : episode.learner)
      if (value.name == "mass") masses.insert(value.value);
  }
  EXPECT_EQ(masses.size(), 6u);
}

TEST_F(WorldRunTest, RefusesWhatIsNoRange) {
  const ProgramResult refused =
      Trainer(TrainPush("run", 2, {"--set", "environment.random_mass=2"}));
  EXPECT_NE(refused.exit_status, 0);
  EXPECT_THAT(refused.errors, HasSubstr("`environment.random_mass` is no range"));
}

}  // namespace
}  // namespace runtime
