// What a person sees who trains on a terminal.
#include "tests/terminal.h"

#include <chrono>
#include <csignal>
#include <thread>

#include "base/text/utf8.h"
#include "tests/runtime/trainer/trainer_test.h"
#include "tests/screen.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kCtrlC = "\x03";

class OnTerminalTest : public TrainerTest {
 protected:
  void SetUp() override {
    if (!HasTerminals()) GTEST_SKIP() << "there are no terminals here";
  }
  std::vector<std::string> Words(std::vector<std::string> more) const {
    std::vector<std::string> words = Training("run", 100'000, std::move(more));
    words.insert(words.begin(), TRAINER);
    return words;
  }
  std::vector<std::string> ManyWords() const {
    return Words({"--runs", "2", "--jobs", "2", "--seed", "3"});
  }
};

std::string Joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

TEST_F(OnTerminalTest, OnePictureFitsTheWindowAndItsLastStateStays) {
  for (const unsigned short columns : {40, 60, 80, 120}) {
    std::filesystem::remove_all(RunFolder("run"));
    std::vector<std::string> words = Training("run", 60);
    words.insert(words.begin(), TRAINER);
    TerminalProgram trainer(words, columns);
    EXPECT_EQ(trainer.Wait(), 0);
    EXPECT_THAT(trainer.printed(), ContainsRegex("episode [0-9]+/60  [^\r\n]*left\x1b"));
    const std::vector<std::string> lines = ScreenLines(trainer.printed(), columns);
    const auto pictures =
        std::ranges::count_if(lines, [](const auto& line) { return line.starts_with("episode "); });
    EXPECT_EQ(pictures, 1) << Joined(lines);
    EXPECT_THAT(lines, Contains(ContainsRegex("^episode 60/60 .*100 %.*  0:00 left")))
        << Joined(lines);
    EXPECT_THAT(lines, Contains(StartsWith("mean of 20 ")).Times(columns == 40 ? 1 : 0));
    EXPECT_THAT(Joined(lines), HasSubstr(" real time"));
    EXPECT_THAT(trainer.printed(), HasSubstr("http://127.0.0.1:"));
  }
}

TEST_F(OnTerminalTest, AWindowThatChangesKeepsOnePicture) {
  TerminalProgram trainer(Words({"--set", "task.limit=2"}), 100);
  ASSERT_TRUE(trainer.WaitFor("/100000  ", 2));
  trainer.Resize(45);
  const size_t before = trainer.printed().size();
  ASSERT_TRUE(trainer.WaitFor("/100000  ", 6));
  trainer.Type(kCtrlC);
  EXPECT_EQ(WEXITSTATUS(trainer.Wait()), 128 + SIGINT);
  const std::vector<std::string> lines = ScreenLines(trainer.printed().substr(before), 45);
  for (const std::string& line : lines) EXPECT_LE(text::DisplayWidth(line), 45u) << line;
  EXPECT_THAT(Joined(lines), HasSubstr("stopped; `trainer resume "));
}

TEST_F(OnTerminalTest, PlainLinesStayWhereTheyWerePrinted) {
  std::vector<std::string> words = Training("run", 60, {"--plain"});
  words.insert(words.begin(), TRAINER);
  TerminalProgram trainer(words, 120);
  EXPECT_EQ(trainer.Wait(), 0);
  EXPECT_THAT(trainer.printed(),
              AllOf(HasSubstr("episode 1/60  return "), HasSubstr("episode 60/60  return ")));
  EXPECT_THAT(trainer.printed(), Not(HasSubstr("\x1b")));
}

TEST_F(OnTerminalTest, CtrlCSaysThatItIsStopping) {
  // In the middle of an episode of half a second: between two there is nothing to wait for.
  TerminalProgram trainer(Words({"--set", "task.limit=10"}), 60);
  ASSERT_TRUE(trainer.WaitFor("/100000  ", 2));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  trainer.Type(kCtrlC);
  EXPECT_EQ(WEXITSTATUS(trainer.Wait()), 128 + SIGINT);
  EXPECT_THAT(trainer.printed(),
              AllOf(HasSubstr("stopping after this episode (saving) ... Ctrl-C again to stop at "
                              "once\r\n"),
                    HasSubstr("stopped; `trainer resume ")));
}

TEST_F(OnTerminalTest, ManyRunsAreOneTableAtEveryWidth) {
  for (const unsigned short columns : {40, 60, 80, 120}) {
    std::filesystem::remove_all(RunFolder("run"));
    TerminalProgram trainer(ManyWords(), columns);
    ASSERT_TRUE(trainer.WaitFor(" episodes", 8));
    trainer.Type(kCtrlC);
    EXPECT_EQ(WEXITSTATUS(trainer.Wait()), 128 + SIGINT);
    const std::vector<std::string> lines = ScreenLines(trainer.printed(), columns);
    const auto heads =
        std::ranges::count_if(lines, [](const auto& line) { return line.starts_with("run  "); });
    EXPECT_EQ(heads, 1) << Joined(lines);
    const std::string told = Joined(lines);
    EXPECT_THAT(told, HasSubstr("stopping after the current episodes"));
    EXPECT_THAT(told, Not(HasSubstr("seed3: stopping")));
    EXPECT_THAT(told, HasSubstr("stopped; `trainer resume "));
  }
}

// Its episodes are so long that the second signal finds one running.
TEST_F(OnTerminalTest, ASecondCtrlCSaysWhatIsKept) {
  const std::vector<std::string> words = {TRAINER,     "train", TaskFile("patient"),
                                          "--profile", "paper", "--episodes",
                                          "100000",    "--out", RunFolder("run")};
  TerminalProgram trainer(words, 120);
  ASSERT_NO_FATAL_FAILURE(WaitForAStep("run"));
  trainer.Type(kCtrlC);
  ASSERT_TRUE(trainer.WaitFor("Ctrl-C again to stop at once"));
  trainer.Type(kCtrlC);
  const int status = trainer.Wait();
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
  EXPECT_THAT(trainer.printed(),
              HasSubstr("stopped at once; kept: nothing; lost: episode 1, which `trainer resume "));
}

TEST_F(OnTerminalTest, ASecondCtrlCStopsManyRunsAtOnce) {
  const std::vector<std::string> words = {TRAINER,         "train",  TaskFile("patient"),
                                          "--profile",     "paper",  "--episodes",
                                          "100000",        "--runs", "2",
                                          "--jobs",        "2",      "--out",
                                          RunFolder("run")};
  TerminalProgram trainer(words, 120);
  ASSERT_TRUE(trainer.WaitFor("2 running"));
  for (const char* run : {"run/seed0", "run/seed1"}) ASSERT_NO_FATAL_FAILURE(WaitForAStep(run));
  trainer.Type(kCtrlC);
  ASSERT_TRUE(trainer.WaitFor("Ctrl-C again to stop at once"));
  trainer.Type(kCtrlC);
  EXPECT_EQ(WEXITSTATUS(trainer.Wait()), 128 + SIGINT);
  EXPECT_THAT(trainer.printed(),
              AllOf(HasSubstr("stopping at once"),
                    HasSubstr("seed1: stopped at once; kept: nothing; lost: episode 1, "),
                    HasSubstr("2 stopped")));
}

}  // namespace
}  // namespace runtime
