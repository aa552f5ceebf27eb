#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/runtime/trainer/trainer_test.h"
#include "tests/runtime/training/run/sample_run.h"

namespace runtime {
namespace {

using testing::HasSubstr;

class ReportTest : public TrainerTest {
 protected:
  // A run of two episodes.
  void Write(const std::string& name, uint64_t seed) const {
    RunRecord run = SampleRun();
    run.seed = seed;
    RunDatabase database = RunDatabase::Create(RunFolder(name), run);
    for (int number = 1; number <= 2; ++number) database.AddEpisode(SampleEpisode(number), {}, {});
  }
  nlohmann::json Figures(const std::string& folder) const {
    const ProgramResult result = Trainer({"report", folder, "--json"});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return nlohmann::json::parse(result.output);
  }
};

TEST_F(ReportTest, OfManyRunsIsOnePage) {
  if (!HAS_REPORT_PAGE) GTEST_SKIP() << "the report's page is not built";
  Write("many/crawling/seed1", 1);
  Write("many/crawling/seed2", 2);
  const ProgramResult result = Trainer({"report", RunFolder("many")});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_EQ(result.output, RunFolder("many") + "/report.html\n");
  EXPECT_GT(std::filesystem::file_size(RunFolder("many") + "/report.html"), 1000u);
}

TEST_F(ReportTest, TellsTheFiguresOfManyRuns) {
  Write("many/crawling/seed1", 1);
  Write("many/crawling/seed2", 2);
  for (const std::string& folder : {RunFolder("many"), RunFolder("many") + "/"}) {
    const nlohmann::json figures = Figures(folder);
    EXPECT_EQ(figures["folder"], "many");
    ASSERT_EQ(figures["experiments"].size(), 1u);
    EXPECT_EQ(figures["experiments"][0]["name"], "crawling");
    EXPECT_EQ(figures["experiments"][0]["runs"][1]["name"], "crawling/seed2");
    EXPECT_EQ(figures["experiments"][0]["final_return"]["count"], 2);
  }
}

TEST_F(ReportTest, TellsTheFiguresOfOneRun) {
  Write("run", 7);
  for (const std::string& folder : {RunFolder("run"), RunFolder("run") + "/"}) {
    const nlohmann::json runs = Figures(folder)["experiments"][0]["runs"];
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(runs[0]["name"], "run");
    EXPECT_EQ(runs[0]["seed"], 7);
  }
}

TEST_F(ReportTest, ADocumentOfOneRunHasItsName) {
  Write("run", 7);
  const ProgramResult result =
      Trainer({"report", RunFolder("run"), "--document", RunFolder("document")});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  std::ostringstream text;
  text << std::ifstream(RunFolder("document") + "/README.md").rdbuf();
  EXPECT_THAT(text.str(), testing::StartsWith("# run\n"));
  EXPECT_THAT(text.str(), testing::Not(HasSubstr("– %")));
}

TEST_F(ReportTest, NamesTheMistakeInGroupsToml) {
  Write("many/seed1", 1);
  std::ofstream(RunFolder("many") + "/groups.toml") << "seed1 = 3\n";
  const ProgramResult result = Trainer({"report", RunFolder("many"), "--json"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("groups.toml:1:"));
}

TEST_F(ReportTest, WritesNoPageWhereItPrints) {
  Write("run", 1);
  EXPECT_EQ(Trainer({"report", RunFolder("run"), "--json", "-o", "page.html"}).exit_status, 2);
}

}  // namespace
}  // namespace runtime
