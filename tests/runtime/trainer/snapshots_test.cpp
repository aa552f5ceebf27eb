#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/runtime/analysis/report/sample_run.h"
#include "tests/runtime/trainer/trainer_test.h"
#include "tests/runtime/training/run/sample_run.h"

namespace runtime {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class SnapshotsTest : public TrainerTest {
 protected:
  // A run of two seconds' crawls, of which every `record_every`th is recorded.
  void WriteRun(int episodes, int record_every) const {
    RunRecord run = SampleRun();
    run.body = SampleRunRecord().body;
    RunDatabase database = RunDatabase::Create(RunFolder("run"), run);
    const Recording recording = SampleRecording(2, 0.3);
    for (int number = 1; number <= episodes; ++number) {
      database.AddEpisode(SampleEpisode(number),
                          number % record_every == 0 ? std::optional(recording) : std::nullopt, {});
    }
  }
  ProgramResult Snapshots(std::vector<std::string> more) const {
    more.insert(more.begin(), {"snapshots", RunFolder("run"), "-o", Strip()});
    return Trainer(more);
  }
  std::string Strip() const { return RunFolder("strip.png"); }
  std::string Bytes() const {
    std::ifstream in(Strip(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(SnapshotsTest, DrawsTheLastRecordedEpisode) {
  WriteRun(5, 2);
  const ProgramResult result = Snapshots({"--count", "3", "--height", "24"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_EQ(result.output, Strip() + ": episode 4 at 0.00, 1.00, 2.00 s\n");
  // A PNG that is three squares wide.
  EXPECT_EQ(Bytes().substr(0, 24),
            std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x48\0\0\0\x18", 24));
}

TEST_F(SnapshotsTest, DrawsAPartOfAnotherEpisode) {
  WriteRun(5, 2);
  const ProgramResult result = Snapshots({"--episode", "2", "--from", "0.5", "--to", "1.5",
                                          "--count", "3", "--height", "24", "--json"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  const nlohmann::json expected = {{"file", Strip()}, {"episode", 2}, {"times", {0.5, 1., 1.5}}};
  EXPECT_EQ(nlohmann::json::parse(result.output), expected);
}

TEST_F(SnapshotsTest, NamesTheEpisodesThatAreRecorded) {
  WriteRun(6, 2);
  const ProgramResult result = Snapshots({"--episode", "5"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("episode 5 is not recorded; it has 2, 4 and 6\n"));
}

TEST_F(SnapshotsTest, NamesTheNearestOfManyEpisodes) {
  WriteRun(60, 4);
  EXPECT_THAT(Snapshots({"--episode", "21"}).errors,
              HasSubstr("not recorded; of the 15 recorded episodes, 20 and 24 are nearest\n"));
  EXPECT_THAT(Snapshots({"--episode", "1"}).errors,
              HasSubstr("15 recorded episodes, 4 is nearest\n"));
  EXPECT_THAT(Snapshots({"--episode", "99"}).errors,
              HasSubstr("15 recorded episodes, 60 is nearest\n"));
}

TEST_F(SnapshotsTest, SaysWhereNothingIsRecorded) {
  WriteRun(1, 2);
  const ProgramResult result = Snapshots({});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("no episode of this run is recorded yet"));
}

TEST_F(SnapshotsTest, RefusesADamagedRecording) {
  RunRecord run = SampleRun();
  run.body = SampleRunRecord().body;
  Recording recording = SampleRecording(1, 0.3);
  recording.poses.resize(recording.poses.size() / 2);
  RunDatabase::Create(RunFolder("run"), run).AddEpisode(SampleEpisode(1), recording, {});
  const ProgramResult result = Snapshots({});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("the recording of episode 1 is damaged"));
}

TEST_F(SnapshotsTest, NamesTheFileThatCannotBeWritten) {
  WriteRun(1, 1);
  const std::string file = RunFolder("none/strip.png");
  const ProgramResult result = Trainer({"snapshots", RunFolder("run"), "-o", file});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors,
              StartsWith("trainer: error: " + file + ": cannot write the pictures: "));
}

TEST_F(SnapshotsTest, RefusesASpanOutsideTheEpisode) {
  WriteRun(1, 1);
  EXPECT_THAT(Snapshots({"--from", "1", "--to", "0.5"}).errors,
              HasSubstr("--from 1 s is after --to 0.5 s"));
  const ProgramResult late = Snapshots({"--from", "3"});
  EXPECT_EQ(late.exit_status, 2);
  EXPECT_THAT(late.errors,
              HasSubstr("--from 3 s is after the end of the episode, which is 2 s long"));
}

}  // namespace
}  // namespace runtime
