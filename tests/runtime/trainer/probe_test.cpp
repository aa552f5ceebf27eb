#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/runtime/analysis/report/report_page.h"
#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class ProbeTest : public TrainerTest {
 protected:
  void SetUp() override {
    if (!HAS_REPORT_PAGE) GTEST_SKIP() << "built without the pages";
  }

  std::vector<std::string> Words(const std::string& name, std::vector<std::string> more) const {
    std::vector<std::string> words = {"probe", TaskFile("leaning"), "--searches",
                                      "2",     "--profile",         "fast",
                                      "--out", RunFolder(name)};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  ProgramResult Probe(const std::string& name, std::vector<std::string> more) const {
    return Trainer(Words(name, std::move(more)));
  }
  // What --json prints, but for what differs from call to call.
  json FiguresOf(const std::string& name, std::vector<std::string> more) const {
    more.push_back("--json");
    const ProgramResult result = Probe(name, std::move(more));
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    json figures = json::parse(result.output);
    figures.erase("folder");
    figures.erase("cpu_minutes");
    return figures;
  }
  size_t EpisodesOf(const std::string& run) const {
    return RunDatabase::OpenToRead(RunFolder(run)).ReadEpisodes().size();
  }
};

TEST_F(ProbeTest, ShowsWhatATaskPaysFor) {
  const ProgramResult result = Probe("probe", {"--episodes", "6"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("leaning: 2 searches, 12 episodes, "), HasSubstr("\nA  "),
                    HasSubstr("\n   forward "), HasSubstr("\n   leaning "),
                    HasSubstr(" m/s fast and "), HasSubstr(" searches found such a motion\n")));
  EXPECT_THAT(result.output, HasSubstr(RunFolder("probe") + "/probe.html\n"));
  EXPECT_TRUE(std::filesystem::exists(RunFolder("probe") + "/probe.html"));
}

TEST_F(ProbeTest, ThePageShowsOneRepetitionOfAMotion) {
  const ProgramResult result = Probe("probe", {"--episodes", "3", "--json",  //
                                               "--set", "action_space.lowest_frequency=10", "--set",
                                               "action_space.highest_frequency=10"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_EQ(json::parse(result.output)["finds"][0]["frequency"], 10);
  const json find = DataOfPage(RunFolder("probe") + "/probe.html")["finds"][0];
  const double from = find["repetition"]["times"].front(), to = find["repetition"]["times"].back();
  EXPECT_NEAR(from, find["seconds"].get<double>() / 2, 0.02);
  EXPECT_NEAR(to - from, 0.1, 0.02);
}

TEST_F(ProbeTest, FindsTheSameWithAnyNumberOfCoresAndInAnyNumberOfCalls) {
  const json figures = FiguresOf("one", {"--episodes", "9", "--jobs", "1"});
  ASSERT_THAT(figures["finds"], Not(IsEmpty()));
  EXPECT_EQ(figures["episodes"], 18);
  EXPECT_EQ(FiguresOf("two", {"--episodes", "9", "--jobs", "2"}), figures);
  FiguresOf("parts", {"--episodes", "4"});
  EXPECT_EQ(FiguresOf("parts", {"--episodes", "9"}), figures);
  EXPECT_NE(FiguresOf("other", {"--episodes", "9", "--seed", "5"}), figures);
}

TEST_F(ProbeTest, AllSearchesEndTogetherWhenTheTimeIsUp) {
  const json figures = FiguresOf("probe", {"--seconds", "1"});
  EXPECT_EQ(EpisodesOf("probe/seed1"), EpisodesOf("probe/seed2"));
  EXPECT_GE(EpisodesOf("probe/seed1"), 10u);
}

TEST_F(ProbeTest, SearchesThatWereGivenUpAreNotTakenUpAgain) {
  const auto probe = [&](const std::string& budget, const std::string& amount) {
    const ProgramResult result =
        Trainer({"probe", TaskFile("leaning"), "--searches", "3", "--profile", "fast", "--out",
                 RunFolder("probe"), budget, amount, "--quiet"});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
  };
  probe("--episodes", "3");
  for (const char* run : {"probe/seed1", "probe/seed3"}) {
    RunDatabase::Open(RunFolder(run)).SetEpisodesPlanned(4);  // as a round does
  }
  probe("--seconds", "1");
  EXPECT_EQ(EpisodesOf("probe/seed2"), 3u);
  EXPECT_GE(EpisodesOf("probe/seed1"), 13u);
  EXPECT_EQ(EpisodesOf("probe/seed3"), EpisodesOf("probe/seed1"));
}

TEST_F(ProbeTest, CtrlCKeepsWhatWasFound) {
  ChildProcess probe([&] {
    std::vector<std::string> words = Words("probe", {"--seconds", "1000"});
    words.insert(words.begin(), TRAINER);
    return words;
  }());
  const auto is_far_enough = [&] {
    return RunDatabase::Exists(RunFolder("probe/seed2")) && EpisodesOf("probe/seed2") >= 12;
  };
  for (int i = 0; i < 6000 && !is_far_enough(); ++i) usleep(10'000);
  ASSERT_TRUE(is_far_enough());
  probe.Send(SIGINT);
  const ProgramResult result = probe.Wait();
  EXPECT_EQ(result.exit_status, 130) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("what was found is kept"));
  EXPECT_THAT(result.output, HasSubstr("\nA  "));
}

TEST_F(ProbeTest, DoesNotMixSearchesOfDifferentAgents) {
  ASSERT_EQ(Probe("probe", {"--episodes", "2"}).exit_status, 0);
  const ProgramResult result = Probe("probe", {"--episodes", "2", "--set", "action_space.dof=all"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, AllOf(HasSubstr("`action_space.dof` is \"5\" there and \"all\" here"),
                                   HasSubstr("give another `--out`")));
}

TEST_F(ProbeTest, ComplainsBeforeItSearches) {
  EXPECT_EQ(Trainer({"probe", "nowhere.task"}).exit_status, 2);
  EXPECT_EQ(Probe("probe", {"--seconds", "5", "--episodes", "5"}).exit_status, 2);
  EXPECT_EQ(Probe("probe", {"--searches", "0"}).exit_status, 2);
  EXPECT_FALSE(std::filesystem::exists(RunFolder("probe")));
}

}  // namespace
}  // namespace runtime
