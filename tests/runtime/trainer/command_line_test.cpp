#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class CommandLineTest : public TrainerTest {};

TEST_F(CommandLineTest, ExplainsEveryCommand) {
  EXPECT_THAT(Trainer({"--help"}).output,
              AllOf(HasSubstr("train"), HasSubstr("resume"), HasSubstr("show"), HasSubstr("report"),
                    HasSubstr("Exit status")));
  for (const char* command :
       {"train", "resume", "show", "report", "snapshots", "video", "evaluate"}) {
    const ProgramResult help = Trainer({command, "--help"});
    EXPECT_EQ(help.exit_status, 0);
    EXPECT_THAT(help.output, HasSubstr(command));
    const ProgramResult version = Trainer({command, "--version"});
    EXPECT_EQ(version.exit_status, 0);
    EXPECT_THAT(version.output, testing::MatchesRegex("trainer [0-9]+\\.[0-9]+\\.[0-9]+\n"));
  }
}

TEST_F(CommandLineTest, RefusesWrongCalls) {
  const std::string task = TaskFile("leaning");
  const std::vector<std::vector<std::string>> wrong_calls = {
      {},
      {"fly"},
      {"train"},
      {"train", task, "--unknown"},
      {"train", task, "--episodes", "0"},
      {"train", task, "--episodes", "many"},
      {"train", task, "--seed", "-1"},
      {"train", task, "--profile", "slow"},
      {"train", task, "--record-every", "-1"},
      {"train", task, "--json", "--quiet"},
      {"train", task, "--set", "learner.temperature"},
      {"train", (folder() / "none.task").string()},
      {"train", (folder() / "none.txt").string()},
      {"resume"},
      {"show"},
      {"report"},
      {"snapshots"},
      {"video"},
      {"video", "runs/none", "-o", "film.gif", "--speed", "0"},
      {"snapshots", "runs/none"},
      {"snapshots", "runs/none", "-o", "strip.png", "--count", "0"},
  };
  for (const std::vector<std::string>& words : wrong_calls) {
    const ProgramResult result = Trainer(words);
    EXPECT_EQ(result.exit_status, 2) << testing::PrintToString(words);
    EXPECT_NE(result.errors, "") << testing::PrintToString(words);
  }
}

TEST_F(CommandLineTest, NamesTheNearestOption) {
  for (const char* option : {"--epsiodes", "--epsiodes=5"}) {
    const ProgramResult result = Trainer({"train", TaskFile("leaning"), option, "5"});
    EXPECT_EQ(result.exit_status, 2);
    EXPECT_THAT(
        result.errors,
        HasSubstr("`trainer train` has no option `--epsiodes`; did you mean `--episodes`?"));
  }
  EXPECT_THAT(Trainer({"ctl", "--rum", "x", "status"}).errors, HasSubstr("did you mean `--run`?"));
}

TEST_F(CommandLineTest, NamesTheNearestCommandAndTask) {
  EXPECT_THAT(Trainer({"trian", "x.task", "--episodes", "5"}).errors,
              HasSubstr("there is no command `trian`; did you mean `trainer train`?"));
  EXPECT_THAT(Trainer({"trian"}).errors, HasSubstr("did you mean `trainer train`?"));
  EXPECT_THAT(Trainer({"train", TaskFile("leanign")}).errors, HasSubstr("`leaning.task`"));
  const std::filesystem::path without_ending =
      std::filesystem::path(TaskFile("leaning")).replace_extension();
  EXPECT_THAT(Trainer({"train", without_ending.string()}).errors,
              HasSubstr("did you mean `" + TaskFile("leaning") + "`?"));
}

TEST_F(CommandLineTest, NamesTheNearestModuleAndParameter) {
  const ProgramResult module = Trainer(Training("run", 1, {"--set", "lerner.temperature=1"}));
  EXPECT_EQ(module.exit_status, 1);
  EXPECT_THAT(module.errors, HasSubstr("learner"));
  const ProgramResult parameter = Trainer(Training("run", 1, {"--set", "learner.temperatur=1"}));
  EXPECT_EQ(parameter.exit_status, 1);
  EXPECT_THAT(parameter.errors, HasSubstr("temperature"));
  EXPECT_FALSE(std::filesystem::exists(RunFolder("run")));
}

TEST_F(CommandLineTest, RefusesAFileThatIsNoPlugin) {
  std::ofstream(folder() / "a.so") << "no shared object";
  const ProgramResult result = Trainer({"train", (folder() / "a.so").string()});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("a.so"));
}

TEST_F(CommandLineTest, RefusesFoldersWithoutARun) {
  for (const char* command : {"resume", "show", "report"}) {
    const ProgramResult result = Trainer({command, RunFolder("none")});
    EXPECT_EQ(result.exit_status, 1) << command;
    EXPECT_THAT(result.errors, HasSubstr(RunFolder("none"))) << command;
  }
}

TEST_F(CommandLineTest, ShowsARun) {
  Train("run", 2, {"--seed", "3", "--quiet"});
  const ProgramResult text = Trainer({"show", RunFolder("run")});
  EXPECT_EQ(text.exit_status, 0);
  EXPECT_THAT(text.output, AllOf(HasSubstr("leaning"), HasSubstr("seed       3"),
                                 HasSubstr("finished"), HasSubstr("2 of 2")));
  const ProgramResult json_text = Trainer({"show", RunFolder("run"), "--json"});
  const nlohmann::json json = nlohmann::json::parse(json_text.output);
  EXPECT_EQ(json["task"], "leaning");
  EXPECT_EQ(json["seed"], 3);
  EXPECT_EQ(json["state"], "finished");
  EXPECT_EQ(json["episodes"], 2);
  int64_t ends = 0;
  for (const nlohmann::json& end : json["ends"]) ends += end["count"].get<int64_t>();
  EXPECT_EQ(ends, 2);
  const std::vector<EpisodeRecord> episodes =
      RunDatabase::OpenToRead(RunFolder("run")).ReadEpisodes();
  EXPECT_EQ(json["best"]["return"].get<double>(),
            std::max(episodes[0].active.episode_return, episodes[1].active.episode_return));
}

TEST_F(CommandLineTest, WritesAReport) {
  if (!HAS_REPORT_PAGE) GTEST_SKIP() << "the report's page is not built";
  Train("run", 2, {"--quiet"});
  const ProgramResult result = Trainer({"report", RunFolder("run")});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_GT(std::filesystem::file_size(std::filesystem::path(RunFolder("run")) / "report.html"),
            1000u);
  const std::string other = (folder() / "other.html").string();
  EXPECT_EQ(Trainer({"report", RunFolder("run"), "-o", other}).exit_status, 0);
  EXPECT_TRUE(std::filesystem::exists(other));
}

}  // namespace
}  // namespace runtime
