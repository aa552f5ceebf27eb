// A run whose database is damaged: every command gives a result, or says in its own words that the
// run is damaged.
#include <array>

#include "tests/runtime/trainer/trainer_test.h"
#include "tests/runtime/training/run/damages.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

class DamagedRunTest : public TrainerTest {
 protected:
  std::filesystem::path Sound() const { return folder() / "sound"; }
  std::filesystem::path Damaged() const { return folder() / "study" / "seed1"; }

  void Restore() const {
    std::filesystem::remove_all(Damaged());
    std::filesystem::create_directories(Damaged().parent_path());
    std::filesystem::copy(Sound(), Damaged());
  }

  // What users call that read a run; more than one of them at once would only cost time.
  std::vector<std::string> Command(size_t index) const {
    const std::string run = Damaged().string();
    const std::string study = Damaged().parent_path().string();
    const std::vector<std::vector<std::string>> commands = {
        {"show", run, "--json"},
        {"resume", run, "--episodes", "4", "--quiet"},
        {"evaluate", run, "--profile", "fast", "--episodes", "1", "--quiet"},
        {"snapshots", run, "-o", (folder() / "strip.png").string()},
        {"report", run, "-o", (folder() / "run.html").string()},
        {"report", study, "-o", (folder() / "study.html").string()},
        {"prefer", study, "--better", "seed1:3", "--worse", "seed1:1"}};
    return commands[index % commands.size()];
  }

  static void ExpectSoundAnswer(const ProgramResult& result, const std::string& what) {
    EXPECT_EQ(result.signal, 0) << what;
    EXPECT_THAT(result.errors,
                Not(AnyOf(HasSubstr("std::"), HasSubstr("_M_"), HasSubstr("exception"),
                          HasSubstr("bad_alloc"), HasSubstr("internal error"))))
        << what;
    if (result.exit_status != 0) {
      EXPECT_THAT(result.errors, HasSubstr("error: ")) << what;
    }
  }
};

TEST_F(DamagedRunTest, NoCommandFallsOverIt) {
  Train("sound", 3, {"--quiet"});
  RunDatabase::Open(Sound()).AddChange(
      {0, 4, 0, "", SetParameter{"task.limit", 0.25}, "task.limit = 0.25"});
  LiftConstraints(Sound() / "run.db");
  const std::vector<Damage> damages = AllDamages(Sound() / "run.db");
  constexpr size_t kStep = 7;  // some of them, of every column: the rest costs minutes
  for (size_t i = 0; i < damages.size(); i += kStep) {
    Restore();
    if (!Apply(damages[i], Damaged() / "run.db")) continue;
    const std::vector<std::string> command = Command(i / kStep);
    ExpectSoundAnswer(Trainer(command), damages[i] + ", then " + command.front());
  }
}

TEST_F(DamagedRunTest, ADamagedCheckpointIsNoticedAndTheRestCanBeUsed) {
  Train("sound", 3, {"--quiet"});
  Restore();
  ASSERT_TRUE(
      Apply("UPDATE checkpoint SET state = CAST(substr(state, 1, 100) || x'00' || "
            "substr(state, 102) AS BLOB)",
            Damaged() / "run.db"));
  for (const size_t command : {1, 2}) {
    const ProgramResult result = Trainer(Command(command));
    EXPECT_EQ(result.exit_status, 1);
    EXPECT_THAT(result.errors, AllOf(HasSubstr((Damaged() / "run.db").string()),
                                     HasSubstr("the checkpoint after episode 3 is damaged"),
                                     HasSubstr("restore a copy"), HasSubstr("`trainer show`")));
  }
  EXPECT_EQ(Trainer(Command(0)).exit_status, 0);
  EXPECT_EQ(RunDatabase::OpenToRead(Damaged()).ReadEpisodes().size(), 3u);
}

}  // namespace
}  // namespace runtime
