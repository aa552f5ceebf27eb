// Plugins that bring the program down that they are loaded in.
#include "tests/runtime/trainer/live_test.h"

namespace runtime {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::SizeIs;

class PluginEndTest : public LiveTest {
 protected:
  void ExpectTheFirstTask() {
    WaitForState("running");
    EXPECT_EQ(TaskNamed("task")["task"], "leaning");
    EXPECT_THAT(Ask({"list"})["tasks"], SizeIs(1));
  }
};

TEST_F(PluginEndTest, ATaskThatExitsIsTakenOutOfTheRun) {
  Serve(100, {"--checkpoint-every", "0"});
  for (const char* name : {"exits", "exits_with_75"}) {
    Ask({"pause"});
    Ask({"swap", "task", Plugin(name), "--now"});
    Ctl({"resume"});  // may have no time to answer
    ASSERT_TRUE(trainer_->WaitForError(
        name == std::string("exits")
            ? "`exits` has failed (it ended the program, with exit status 0)"
            : "`exits` has failed (it ended the program, with exit status 75)"));
    ExpectTheFirstTask();
    EXPECT_THAT(Refusal({"swap", "task", Plugin(name)}), HasSubstr("has crashed in this run"));
  }
  EXPECT_EQ(Stop().exit_status, 0);
  EXPECT_THAT(Changes(), Contains(HasSubstr("quarantine")).Times(2));
}

TEST_F(PluginEndTest, ATaskThatExitsWhileItIsLoadedDoesNoHarm) {
  Serve(100, {"--checkpoint-every", "0"});
  Ask({"resume"});
  Ctl({"load", Plugin("exits_on_load")});
  ASSERT_TRUE(trainer_->WaitForError("a task could not be loaded (it ended the program"));
  ExpectTheFirstTask();
  EXPECT_EQ(Stop().exit_status, 0);
}

TEST_F(PluginEndTest, NorDoesOneThatIsNeverLoadedWhileTheRunLearns) {
  Serve(1'000'000, {"--checkpoint-every", "0"});
  Ask({"resume"});
  Ctl({"load", Plugin("loops_on_load")});
  ASSERT_TRUE(trainer_->WaitForError("a task could not be loaded (it did not return"));
  ExpectTheFirstTask();
  EXPECT_EQ(Stop().exit_status, 0);
}

// Of the episodes that run then, it cannot be told which one has failed: they are run again, one at
// a time.
TEST_F(PluginEndTest, OneThatCrashesInEpisodesSideBySideIsFound) {
  Serve(1'000'000, {"--agent", "ppo", "--jobs", "3", "--checkpoint-every", "0"},
        TaskFile("swaying"));
  Ask({"load", Plugin("stumbles"), "as", "shadow"});
  Ctl({"resume"});
  ASSERT_TRUE(trainer_->WaitForError("one episode at a time"));
  ASSERT_TRUE(trainer_->WaitForError("the task `stumbles` has failed (crash: "));
  WaitForState("running");
  EXPECT_THAT(Ask({"list"})["tasks"], SizeIs(1));
  EXPECT_EQ(Stop().exit_status, 0);
  EXPECT_THAT(Changes(), Contains(HasSubstr("quarantine")).Times(1));
}

// Nothing is known of a run yet.
TEST_F(PluginEndTest, AFirstTaskThatExitsIsAFailure) {
  const ProgramResult result =
      Trainer({"train", Plugin("exits_on_load"), "--robot", "humanoid", "--out", RunFolder("run")});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors,
              HasSubstr("its code ended the process that loaded it (exit status 0)"));
}

}  // namespace
}  // namespace runtime
