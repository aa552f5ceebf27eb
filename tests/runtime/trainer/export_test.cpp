#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/runtime/analysis/report/sample_run.h"
#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// What is in the files of what is recorded is tested where they are made, and by
// web/tests/exports.ts.
class ExportTest : public TrainerTest {
 protected:
  void WriteRun(const std::string& name) const {
    WriteSampleRun(RunFolder(name), {.episodes = 6, .record_every = 2, .duration = 1});
  }
  ProgramResult Export(std::vector<std::string> words) const {
    words.insert(words.begin(), "export");
    return Trainer(words);
  }
  std::string Bytes(const std::string& file) const {
    std::ifstream in(RunFolder(file), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(ExportTest, WritesAllThatItIsAskedFor) {
  WriteRun("run");
  const ProgramResult result =
      Export({RunFolder("run"), "--csv", RunFolder("run.csv"), "--tensorboard", RunFolder("board"),
              "--mcap", RunFolder("last.mcap")});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_EQ(result.output, RunFolder("run.csv") + "\n" +
                               RunFolder("board/events.out.tfevents.taskc") + "\n" +
                               RunFolder("last.mcap") + "\n");
  EXPECT_THAT(Bytes("run.csv"), StartsWith("episode,end,reason,return,"));
  EXPECT_THAT(Bytes("board/events.out.tfevents.taskc"), HasSubstr("brain.Event:2"));
  EXPECT_THAT(Bytes("last.mcap"), StartsWith("\x89MCAP0\r\n"));
}

TEST_F(ExportTest, OfManyRunsEachHasItsFolder) {
  WriteRun("study/a");
  WriteRun("study/b");
  const ProgramResult result = Export({RunFolder("study"), "--tensorboard", RunFolder("board"),
                                       "--csv", RunFolder("study.csv"), "--json"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_EQ(nlohmann::json::parse(result.output)["files"].size(), 3u);
  EXPECT_NE(Bytes("board/a/events.out.tfevents.taskc"), "");
  EXPECT_NE(Bytes("board/b/events.out.tfevents.taskc"), "");
  EXPECT_THAT(Bytes("study.csv"), HasSubstr("\nb,6,"));
}

TEST_F(ExportTest, ChoosesAnEpisode) {
  WriteRun("run");
  const auto mcap = [&](const char* episode) {
    return Export({RunFolder("run"), "--mcap", RunFolder("one.mcap"), "--episode", episode});
  };
  EXPECT_EQ(mcap("2").exit_status, 0);
  EXPECT_THAT(Bytes("one.mcap"), HasSubstr(std::string("episode\1\0\0\0"
                                                       "2",
                                                       12)));
  const ProgramResult result = mcap("77");
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("episode 77 is not recorded; "));
}

TEST_F(ExportTest, SaysWhatIsMissing) {
  WriteRun("run");
  const ProgramResult nothing = Export({RunFolder("run")});
  EXPECT_EQ(nothing.exit_status, 2);
  EXPECT_THAT(nothing.errors,
              HasSubstr("--mcap FILE, --motion FILE, --onnx FILE, --c-header FILE"));
  const ProgramResult episode = Export({RunFolder("run"), "--episode", "2", "--csv", "x"});
  EXPECT_EQ(episode.exit_status, 2);
  EXPECT_EQ(Export({RunFolder("none"), "--csv", "x"}).exit_status, 1);
}

}  // namespace
}  // namespace runtime
