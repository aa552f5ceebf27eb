#include "runtime/training/run/run_settings.h"

#include <gmock/gmock.h>

#include "tests/runtime/training/run/sample_run.h"

namespace runtime {
namespace {

using testing::IsEmpty;

RunRecord RunWithSettings() {
  RunRecord run = SampleRun();
  run.seed = 7;
  run.settings = SettingsText(
      {{"task.fall_penalty", "8.0", "--set"}, {"learner.temperature", "2.0", "warm.toml:2:1"}});
  run.call = CallText({"my tasks/it's.task", "--set", "task.fall_penalty=8"});
  return run;
}

TEST(RunSettings, AreReadAsTheyWereWritten) {
  const RunRecord run = RunWithSettings();
  const std::vector<Setting> settings = SettingsOf(run);
  ASSERT_EQ(settings.size(), 2u);
  EXPECT_EQ(settings[1].name, "learner.temperature");
  EXPECT_EQ(settings[1].value, "2.0");
  EXPECT_EQ(settings[1].origin, "warm.toml:2:1");
  EXPECT_EQ(SettingsJson(run).dump(), run.settings);
}

TEST(RunSettings, TheCommandIsForAShell) {
  EXPECT_EQ(TrainCommand(RunWithSettings()),
            "trainer train 'my tasks/it'\\''s.task' --set task.fall_penalty=8 --profile fast "
            "--episodes 1000 --seed 7");
  EXPECT_THAT(TrainCommand(RunWithSettings(), 3), testing::EndsWith(" --seed 7 --runs 3"));
}

TEST(RunSettings, AreNoneWhereTheyWereNotWrittenDown) {
  RunRecord run = SampleRun();
  for (const char* damaged : {"", "{", "7", "[3, {\"name\": 3}]"}) {
    run.settings = run.call = damaged;
    for (const Setting& setting : SettingsOf(run)) EXPECT_EQ(setting.name, "");
    EXPECT_EQ(TrainCommand(run), "");
  }
  run.settings = "";
  EXPECT_THAT(SettingsOf(run), IsEmpty());
}

}  // namespace
}  // namespace runtime
