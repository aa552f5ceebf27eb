// `trainer reproduce`: a run from its record alone, held against what was recorded.
#include <cstdlib>
#include <fstream>

#include "tests/runtime/trainer/live_test.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class ReproduceTest : public LiveTest {
 protected:
  ProgramResult Reproduce(std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"reproduce", RunFolder("run")};
    words.insert(words.end(), more.begin(), more.end());
    return Trainer(std::move(words));
  }
  // Of `--json`, for a run that is not the same.
  json Difference() const {
    const ProgramResult result = Reproduce({"--json"});
    EXPECT_EQ(result.exit_status, 1) << result.errors;
    return json::parse(result.output);
  }
  void Change(const std::string& sql) const {
    SqliteDatabase(folder() / "run" / "run.db", SqliteAccess::kWrite).Execute(sql, "change it");
  }
  static json Cause(const json& found, const std::string& name) {
    for (const json& cause : found["causes"]) {
      if (cause["name"] == name) return cause;
    }
    return {};
  }
};

TEST_F(ReproduceTest, ARunIsTheSameFromItsRecordAlone) {
  const std::filesystem::path task = folder() / "mine" / "short.task";
  std::filesystem::create_directories(task.parent_path());
  std::filesystem::copy_file(TaskFile("leaning"), task);
  const ProgramResult trained =
      Trainer({"train", task.string(), "--profile", "fast", "--episodes", "6", "--out",
               RunFolder("run"), "--set", "task.limit=0.2", "--quiet"});
  ASSERT_EQ(trained.exit_status, 0) << trained.errors;
  std::filesystem::remove_all(task.parent_path());
  for (const auto& entry : std::filesystem::directory_iterator(RunFolder("run"))) {
    if (entry.path().extension() == ".so") std::filesystem::remove(entry.path());
  }
  const ProgramResult result = Reproduce();
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("episodes 1 to 6 trained again from the record: equal, bit for bit"),
                    HasSubstr("; so is what was learned")));
  EXPECT_EQ(Reproduce({"--episodes", "2", "--quiet"}).output, "");
  EXPECT_EQ(Reproduce({"--episodes", "7"}).exit_status, 2);
  EXPECT_EQ(Reproduce({"--kept-plugins"}).exit_status, 1);  // they are gone
}

TEST_F(ReproduceTest, WhatWasChangedLiveIsChangedAgain) {
  Serve(100, {"--checkpoint-every", "0"});
  Ask({"set", "task.limit", "0.1", "s"});
  RunSteps(7);
  Ask({"swap", "task", TaskFile("upright"), "--now"});
  Ask({"load", TaskFile("leaning"), "as", "shadow"});
  RunEpisodes(2);
  Ask({"promote", "shadow"});
  Ask({"set", "learner.temperature", "=", "2", "->", "0.5", "over", "3", "episodes"});
  RunEpisodes(4);
  Stop();
  const ProgramResult result = Reproduce();
  EXPECT_EQ(result.exit_status, 0) << result.output << result.errors;
  EXPECT_THAT(result.output, HasSubstr("bit for bit, with 5 live changes"));
  const ProgramResult kept = Reproduce({"--kept-plugins", "--json"});
  EXPECT_EQ(kept.exit_status, 0) << kept.errors;
  EXPECT_EQ(json::parse(kept.output)["is_equal"], true);
}

TEST_F(ReproduceTest, TheFirstDifferenceIsShown) {
  Train("run", 5);
  Change("UPDATE evaluation SET return = return + 1 WHERE episode = 3");
  Change("UPDATE evaluation_term SET sum = 17.25 WHERE episode = 4");
  const json found = Difference();
  EXPECT_EQ(found["equal_episodes"], 2);
  EXPECT_EQ(found["difference"]["episode"], 3);
  EXPECT_EQ(found["difference"]["values"].size(), 1);
  EXPECT_EQ(found["difference"]["values"][0]["name"], "return");
  for (const json& cause : found["causes"]) EXPECT_EQ(cause["is_equal"], true) << cause;
  const ProgramResult result = Reproduce();
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.output, AllOf(HasSubstr("episode 3 differs; the 2 before are equal"),
                                   HasSubstr("the record was changed after it was written")));
}

TEST_F(ReproduceTest, WhatComputesOtherwiseIsNamed) {
  Train("run", 3);
  Change(
      "UPDATE machine SET facts = json_set(facts, '$.libm', 'glibc 2.17', '$.processor', "
      "'x86_64')");
  Change("UPDATE evaluation SET return = 0 WHERE episode = 1");
  const json found = Difference();
  EXPECT_EQ(Cause(found, "libm")["recorded"], "glibc 2.17");
  EXPECT_EQ(Cause(found, "libm")["is_equal"], false);
  EXPECT_EQ(Cause(found, "ODE")["is_equal"], true);
  EXPECT_THAT(Cause(found, "ODE")["here"].get<std::string>(), HasSubstr("libode"));
  EXPECT_THAT(found["causes"][0]["name"].get<std::string>(), HasSubstr("compiler of task leaning"));
  EXPECT_THAT(Reproduce().output, AllOf(HasSubstr("what computes differs as well"),
                                        HasSubstr("glibc 2.17 in the"), Not(HasSubstr("ODE"))));
}

TEST_F(ReproduceTest, ARecordOfAnOlderVersionIsReproducedAsWell) {
  Train("run", 2);
  Change("DROP TABLE machine");
  EXPECT_EQ(Reproduce({"--quiet"}).exit_status, 0);
  Change("UPDATE evaluation SET end_reason = 'other'");
  const json found = Difference();
  EXPECT_EQ(found["difference"]["values"][0]["name"], "end");
  EXPECT_EQ(Cause(found, "libm")["recorded"], nullptr);
  EXPECT_THAT(Reproduce().output,
              AllOf(HasSubstr("the record does not say: trainer"), HasSubstr(", libm")));
}

TEST_F(ReproduceTest, ATextThatIsNotTheTasksIsRefused) {
  Train("run", 1);
  Change("UPDATE source SET text = replace(text, '0.125', '0.5')");
  ProgramResult result = Reproduce();
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors,
              AllOf(HasSubstr("it is of another version"), HasSubstr("--kept-plugins")));
  Change("UPDATE source SET text = 'task'");
  result = Reproduce();
  EXPECT_THAT(result.errors, HasSubstr("cannot be built from its text in the record"));
  EXPECT_EQ(Reproduce({"--kept-plugins", "--quiet"}).exit_status, 0);
}

}  // namespace
}  // namespace runtime
