#include <fstream>
#include <nlohmann/json.hpp>

#include "runtime/analysis/preference/preferences_file.h"
#include "runtime/training/run/run_files.h"
#include "tests/runtime/analysis/study/sample_preferences.h"
#include "tests/runtime/trainer/trainer_test.h"
#include "tests/terminal.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

class PreferTest : public TrainerTest {
 protected:
  void SetUp() override { WriteThreeEndings(study()); }
  std::filesystem::path study() const { return folder() / "study"; }
  std::string File(const std::string& name) const { return (folder() / name).string(); }

  ProgramResult Prefer(std::vector<std::string> words) const {
    words.insert(words.begin(), {"prefer", study().string()});
    return Trainer(std::move(words));
  }
  // On a terminal.
  std::string Asked(const std::string& answers) const {
    return PrintedOnTerminal({TRAINER, "prefer", study().string()}, answers);
  }
  nlohmann::json Json(std::vector<std::string> words = {}) const {
    words.push_back("--json");
    const ProgramResult result = Prefer(std::move(words));
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return nlohmann::json::parse(result.output);
  }
  static bool Taskc(std::vector<std::string> words) {
    words.insert(words.begin(), (std::filesystem::path(TRAINER).parent_path() / "taskc").string());
    return RunProgram(std::move(words)).exit_status == 0;
  }
};

TEST_F(PreferTest, AStatementIsKeptAndFitted) {
  const ProgramResult result = Prefer({"--better", "seed3", "--worse", "seed1"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("crawling: of 1 preference, 0 hold now, "));
  EXPECT_THAT(result.output, HasSubstr("\n  fall_penalty      4"));
  EXPECT_THAT(result.output, HasSubstr("\n  seed3 over seed1"));
  EXPECT_THAT(result.output, HasSubstr("fall_penalty also affects when an episode ends"));
  const std::vector<Preference> preferences = ReadPreferences(study());
  ASSERT_THAT(preferences, SizeIs(1));
  EXPECT_EQ(preferences[0].text(), "crawling/seed3 over crawling/seed1");
}

TEST_F(PreferTest, AnOrderIsThePreferencesOfItsNeighbors) {
  const nlohmann::json experiment =
      Json({"--order", "seed3", "seed1:20", "seed2"})["experiments"][0];
  EXPECT_EQ(experiment["experiment"], "crawling");
  ASSERT_THAT(experiment["preferences"], SizeIs(2));
  EXPECT_EQ(experiment["preferences"][1]["better"], "crawling/seed1:20");
  EXPECT_LT(experiment["weights"][0]["after"], 4);
  ASSERT_THAT(Json({"--equal", "seed2", "seed1"})["experiments"][0]["preferences"], SizeIs(3));
}

TEST_F(PreferTest, WhatWasStatedBeforeIsFittedAgain) {
  const nlohmann::json first = Json({"--better", "seed3", "--worse", "seed1"});
  EXPECT_EQ(Json(), first);
  EXPECT_EQ(Json({"--better", "seed3", "--worse", "seed1"}), first);
}

TEST_F(PreferTest, TheReportTellsTheSame) {
  const nlohmann::json outcome = Json({"--better", "seed3", "--worse", "seed1"})["experiments"][0];
  const ProgramResult result = Trainer({"report", study().string(), "--json"});
  const nlohmann::json figures = nlohmann::json::parse(result.output);
  EXPECT_EQ(figures["experiments"][0]["preferences"], outcome);
}

TEST_F(PreferTest, TheNewWeightsAreATaskThatTaskcBuilds) {
  const std::string file = File("tasks/careless.task");
  const ProgramResult result = Prefer({"--better", "seed3", "--worse", "seed1", "-o", file});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("wrote " + file));
  EXPECT_THAT(result.output,
              HasSubstr("trainer train " + file +
                        " --profile paper --episodes 20 --seed 1 --runs 3 --out runs/careless"));
  const std::string text = ReadText(file);
  EXPECT_THAT(text, AllOf(HasSubstr("task careless extends \"../"),
                          HasSubstr("1 preference in crawling of study"),
                          HasSubstr("override param fall_penalty = "), HasSubstr("  // was 4\n")));
  EXPECT_TRUE(Taskc({"build", file, "-o", file + ".so"}));
  EXPECT_TRUE(Taskc({"fmt", "--check", file}));
}

TEST_F(PreferTest, ATaskIsWrittenOverOnlyOnWish) {
  const std::string file = File("careless.task");
  std::ofstream(file) << "mine";
  const std::vector<std::string> words = {"--better", "seed3", "--worse", "seed1", "-o", file};
  const ProgramResult refused = Prefer(words);
  EXPECT_EQ(refused.exit_status, 1);
  EXPECT_THAT(refused.errors, HasSubstr("already exists"));
  EXPECT_EQ(ReadText(file), "mine");
  EXPECT_EQ(Prefer({"-o", file, "--force"}).exit_status, 0);
  EXPECT_THAT(ReadText(file), HasSubstr("task careless extends"));
}

// The weights are those of the recorded text; what is extended must be the same.
TEST_F(PreferTest, AFileThatHasChangedIsNotExtended) {
  std::ofstream(File("other.task")) << "task other for humanoid\n";
  const ProgramResult result = Prefer({"--better", "seed3", "--worse", "seed1", "-o",
                                       File("careless.task"), "--task", File("other.task")});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, AllOf(HasSubstr("other.task has changed"), HasSubstr("--task FILE")));
  EXPECT_FALSE(std::filesystem::exists(File("careless.task")));
  EXPECT_THAT(Prefer({"-o", File("careless.task"), "--task", File("gone.task")}).errors,
              HasSubstr("no longer exists"));
}

TEST_F(PreferTest, TheAgentOfTheTaskGoesWithIt) {
  std::filesystem::copy(SOURCE_DIR "/tasks/crawling.task", File("crawling.task"));
  std::ofstream(File("crawling.agent.toml")) << "[modules.learner]\ntemperature = 3\n";
  const std::string file = File("careless.task");
  ASSERT_EQ(
      Prefer({"--better", "seed3", "--worse", "seed1", "-o", file, "--task", File("crawling.task")})
          .exit_status,
      0);
  EXPECT_THAT(ReadText(file), HasSubstr("extends \"crawling.task\""));
  EXPECT_THAT(Trainer({"agent", "show", file}).output, HasSubstr("temperature = 3"));
}

TEST_F(PreferTest, WhatCannotBeComparedIsNotWrittenDown) {
  WriteEnding(study() / "crawling" / "seed4", {.seed = 4, .terms = {1, 0, 0, 0}, .episodes = 12});
  const std::pair<std::vector<std::string>, std::string> mistakes[] = {
      {{"--better", "seed3", "--worse", "seed9"}, "there is no run `seed9`"},
      {{"--better", "seed3", "--worse", "seed4"}, "compare one of its episodes"},
      {{"--better", "seed3", "--worse", "seed1:21"}, "has no episode 21"},
      {{"--better", "seed3", "--worse", "seed3"}, "compared with itself"},
      {{"--better", "seed3"}, "--worse"},
      {{"--experiment", "walking"}, "there are crawling"},
      {{}, "no preferences are stated yet"},
  };
  for (const auto& [words, message] : mistakes) {
    const ProgramResult result = Prefer(words);
    EXPECT_NE(result.exit_status, 0) << message;
    EXPECT_THAT(result.errors, HasSubstr(message));
  }
  EXPECT_FALSE(std::filesystem::exists(study() / "preferences.toml"));
}

TEST_F(PreferTest, AMistakeInTheFileIsShownWithItsPlace) {
  std::ofstream(study() / "preferences.toml") << "[[preference]]\nbetter = 'crawling/seed1'\n";
  EXPECT_THAT(Prefer({}).errors, HasSubstr("preferences.toml:1:1: "));
}

TEST_F(PreferTest, AsksOnATerminal) {
  if (!HasTerminals()) GTEST_SKIP() << "there are no terminals here";
  const std::string printed = Asked("what\nb\ns\n=\n");
  EXPECT_THAT(printed, AllOf(HasSubstr("a  group B, as seed2; 1 run"), HasSubstr("distance 10 m"),
                             HasSubstr("of 2 preferences")));
  const std::vector<Preference> preferences = ReadPreferences(study());
  ASSERT_THAT(preferences, SizeIs(2));
  EXPECT_EQ(preferences[0].text(), "crawling/seed3 over crawling/seed2");
  EXPECT_TRUE(preferences[1].is_tie);
}

TEST_F(PreferTest, AnswersStayWhereTheQuestionsAreBrokenOff) {
  if (!HasTerminals()) GTEST_SKIP() << "there are no terminals here";
  EXPECT_THAT(Asked("a\nq\n"), HasSubstr("of 1 preference"));
  EXPECT_THAT(ReadPreferences(study()), SizeIs(1));
}

}  // namespace
}  // namespace runtime
