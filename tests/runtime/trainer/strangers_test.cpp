// Runs that somebody else has made: who only looks at them runs none of their code.
#include <gmock/gmock.h>

#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::HasSubstr;

class StrangersTest : public TrainerTest {
 protected:
  // A run whose plugin ends the program, with success, as soon as it is loaded.
  void MakeRun() const {
    Train("run", 3);
    for (const auto& entry : std::filesystem::directory_iterator(RunFolder("run"))) {
      if (entry.path().extension() != ".so") continue;
      std::filesystem::copy_file(std::string(PLUGIN_FOLDER) + "/exits_on_load.so", entry.path(),
                                 std::filesystem::copy_options::overwrite_existing);
    }
  }
  // It has come to its end, and made what it was asked for.
  void ExpectMakes(std::vector<std::string> words, const std::string& file) const {
    const ProgramResult result = Trainer(std::move(words));
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    EXPECT_TRUE(std::filesystem::exists(folder() / file)) << file;
  }
};

TEST_F(StrangersTest, ShowAndReportLoadNoPlugin) {
  MakeRun();
  EXPECT_THAT(Trainer({"show", RunFolder("run")}).output, HasSubstr("leaning"));
  EXPECT_THAT(Trainer({"show", folder().string()}).output, HasSubstr("finished"));
  EXPECT_THAT(Trainer({"study", "status", folder().string()}).output, HasSubstr("finished"));
  if (HAS_REPORT_PAGE) {
    ExpectMakes({"report", RunFolder("run"), "-o", RunFolder("one.html")}, "one.html");
    ExpectMakes({"report", folder().string(), "-o", RunFolder("all.html")}, "all.html");
  }
  ExpectMakes({"export", RunFolder("run"), "--csv", RunFolder("a.csv")}, "a.csv");
  ExpectMakes({"export", RunFolder("run"), "--mcap", RunFolder("a.mcap")}, "a.mcap");
  ExpectMakes({"snapshots", RunFolder("run"), "-o", RunFolder("a.png")}, "a.png");
}

TEST_F(StrangersTest, WhatWouldRunAPluginThatWasReplacedRefusesIt) {
  MakeRun();
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"resume", RunFolder("run"), "--episodes", "5"},
        {"evaluate", RunFolder("run"), "--profile", "fast"},
        {"reproduce", RunFolder("run"), "--kept-plugins"}}) {
    const ProgramResult result = Trainer(words);
    EXPECT_EQ(result.exit_status, 1);
    EXPECT_THAT(result.errors, HasSubstr("the run's plugin was changed")) << words.front();
  }
  EXPECT_EQ(Trainer({"reproduce", RunFolder("run"), "--quiet"}).exit_status, 0);
}

}  // namespace
}  // namespace runtime
