// A run's database that holds what no trainer has written: whoever reads it gets what is right, or
// one error that names the file.
#include <gmock/gmock.h>

#include "runtime/training/run/run_database.h"
#include "tests/runtime/training/run/damages.h"
#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/sample_run.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class DamageTest : public testing::Test {
 protected:
  DamageTest() {
    RunDatabase database = RunDatabase::Create(sound_, SampleRun());
    database.AddTask(SampleVersion());
    EpisodeRecord shadowed = SampleEpisode(2);
    shadowed.shadows = {SampleShadow()};
    database.AddEpisode(SampleEpisode(1), Recording{3, 0.02, true, "poses", "timeline"}, {});
    database.AddEpisode(shadowed, Recording{3, 0.02, false, "poses", "timeline"},
                        Checkpoint{2, "state"});
    database.AddChange({0, 1, 20, "2026-01-02T03:04:05Z", SetParameter{"task.gain", int64_t{2}},
                        "set task.gain = 2"});
    database.AddChange(
        {0, 2, 0, "2026-01-02T03:04:05Z", LoadShadow{"careful", 2}, "load careful: crawling"});
  }

  // All that can be read, each without the others: one that fails must not hide the next.
  std::vector<std::string> ErrorsOfReaders(const std::filesystem::path& folder) const {
    std::vector<std::string> errors;
    std::optional<RunDatabase> database;
    errors.push_back(ErrorOf([&] { database = RunDatabase::OpenToRead(folder); }));
    if (!database) return errors;
    const auto read = [&](auto member) {
      errors.push_back(ErrorOf([&] { (*database.*member)(); }));
    };
    read(&RunDatabase::ReadRun);
    read(&RunDatabase::ReadState);
    read(&RunDatabase::ReadEpisodes);
    read(&RunDatabase::ReadChanges);
    read(&RunDatabase::ReadCheckpoint);
    read(&RunDatabase::ReadRecordedEpisodes);
    errors.push_back(ErrorOf([&] { database->ReadRecording(2); }));
    std::erase(errors, "");
    return errors;
  }

  std::filesystem::path CopyOf(const std::filesystem::path& folder) const {
    const std::filesystem::path copy = parent_.path() / "copy";
    std::filesystem::remove_all(copy);
    std::filesystem::copy(folder, copy);
    return copy;
  }

  // The errors of all readers after this damage.
  std::vector<std::string> ErrorsAfter(const Damage& damage) const {
    const std::filesystem::path damaged = CopyOf(sound_);
    EXPECT_TRUE(Apply(damage, damaged / "run.db")) << damage;
    return ErrorsOfReaders(damaged);
  }

  TemporaryFolder parent_;
  const std::filesystem::path sound_ = parent_.path() / "run";
};

TEST_F(DamageTest, NobodyFallsOverWhatNoTrainerHasWritten) {
  LiftConstraints(sound_ / "run.db");
  ASSERT_THAT(ErrorsOfReaders(sound_), testing::IsEmpty());
  int damaged = 0;
  int noticed = 0;
  for (const Damage& damage : AllDamages(sound_ / "run.db")) {
    const std::filesystem::path folder = CopyOf(sound_);
    if (!Apply(damage, folder / "run.db")) continue;
    ++damaged;
    const std::vector<std::string> errors = ErrorsOfReaders(folder);
    if (!errors.empty()) ++noticed;
    for (const std::string& error : errors) {
      EXPECT_THAT(error, AllOf(HasSubstr((folder / "run.db").string()), HasSubstr("damaged"),
                               Not(HasSubstr("check the disk"))))
          << damage;
    }
  }
  EXPECT_GT(damaged, 800);
  EXPECT_GT(noticed, 2 * damaged / 3);  // the rest cannot be told from what may be there
}

TEST_F(DamageTest, TheErrorNamesTheRowTheColumnAndTheRemedy) {
  EXPECT_THAT(ErrorsAfter("UPDATE episode SET steps = -3 WHERE number = 2"),
              testing::Each(AllOf(HasSubstr("copy/run.db: the run is damaged: the table `episode`, "
                                            "row 2: `steps` cannot be -3; restore a copy"))));
  EXPECT_THAT(ErrorsAfter("UPDATE run SET value = 'many' WHERE key = 'episodes_planned'"),
              testing::ElementsAre(HasSubstr("the table `run` says that `episodes_planned` is "
                                             "`many`")));
}

// What each of these would have done: another curve under a term's name, a task out of range, an
// episode twice, a loop of years.
TEST_F(DamageTest, NoticesWhatOnlySeveralTablesTell) {
  for (const char* damage :
       {"DELETE FROM evaluation_term WHERE episode = 1 AND id = 0",
        "DELETE FROM evaluation_log WHERE episode = 2 AND id = 1",
        "DELETE FROM evaluation WHERE episode = 1", "UPDATE evaluation SET task = task + 5",
        "UPDATE evaluation SET is_active = 1", "DELETE FROM term WHERE id = 1",
        "DELETE FROM episode WHERE number = 1", "UPDATE task SET id = 9 WHERE id = 2",
        "UPDATE recording SET episode = 7 WHERE episode = 2",
        "UPDATE change SET data = replace(data, '\"task\":2', '\"task\":3')",
        "UPDATE change SET kind = 'swap'", "DELETE FROM source WHERE task = 2",
        "UPDATE checkpoint SET episode = 1", "UPDATE checkpoint SET episode = 4000000000"}) {
    EXPECT_THAT(ErrorsAfter(damage), Not(testing::IsEmpty())) << damage;
  }
}

}  // namespace
}  // namespace runtime
