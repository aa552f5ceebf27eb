#include <fstream>

#include "tests/runtime/analysis/report/sample_run.h"
#include "tests/runtime/trainer/trainer_test.h"
#include "tests/runtime/training/run/sample_run.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class VideoTest : public TrainerTest {
 protected:
  // A run with two recorded crawls of a second.
  VideoTest() {
    RunRecord run = SampleRun();
    run.body = SampleRunRecord().body;
    RunDatabase database = RunDatabase::Create(RunFolder("run"), run);
    for (int number = 1; number <= 2; ++number) {
      database.AddEpisode(SampleEpisode(number), SampleRecording(1, 0.3), {});
    }
  }
  ProgramResult Video(const std::string& file, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"video", RunFolder("run"), "-o", RunFolder(file)});
    return Trainer(more);
  }
  // In a build without the library for such files.
  static bool CannotWrite(const ProgramResult& result) {
    return result.errors.find("was built without") != std::string::npos;
  }
  std::string Bytes(const std::string& file) const {
    std::ifstream in(RunFolder(file), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(VideoTest, DrawsTheLastRecordedEpisodeAsGif) {
  const ProgramResult result = Video("film.gif", {"--size", "32"});
  if (CannotWrite(result)) GTEST_SKIP() << result.errors;
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_EQ(result.output, RunFolder("film.gif") + ": episode 2, 26 pictures, 1.04 s\n");
  EXPECT_EQ(result.errors, "");  // no terminal, no progress
  EXPECT_THAT(Bytes("film.gif"), StartsWith(std::string("GIF89a\x20\0\x20\0", 10)));
}

TEST_F(VideoTest, DrawsAPartSlowlyAsWebm) {
  const ProgramResult result = Video("film.webm", {"--episode", "1", "--speed", "0.5", "--from",
                                                   "0.2", "--to", "0.6", "--size", "31"});
  if (CannotWrite(result)) GTEST_SKIP() << result.errors;
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("film.webm: episode 1, 21 pictures, 0.84 s\n"));
  EXPECT_THAT(Bytes("film.webm"), StartsWith("\x1A\x45\xDF\xA3"));
}

TEST_F(VideoTest, DrawsAnEpisodeAsMp4) {
  const ProgramResult result = Video("film.mp4", {"--size", "32", "--to", "0.4"});
  if (CannotWrite(result)) GTEST_SKIP() << result.errors;
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("film.mp4: episode 2, 11 pictures, 0.44 s\n"));
  EXPECT_EQ(result.errors, "");
  EXPECT_THAT(Bytes("film.mp4"), AllOf(HasSubstr("ftypisom"), HasSubstr("avc1")));
}

TEST_F(VideoTest, IsTheSameFileEachTime) {
  for (const std::string ending : {".gif", ".mp4", ".webm"}) {
    for (const char* name : {"one", "two"}) {
      const ProgramResult result = Video(name + ending, {"--size", "24", "--to", "0.2"});
      if (CannotWrite(result)) GTEST_SKIP() << result.errors;
    }
    EXPECT_FALSE(Bytes("one" + ending).empty());
    EXPECT_TRUE(Bytes("one" + ending) == Bytes("two" + ending)) << ending;
  }
}

TEST_F(VideoTest, SaysWhatItCanWrite) {
  const ProgramResult result = Video("film.avi");
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("film.avi: films are written as .mp4"));
  EXPECT_FALSE(std::filesystem::exists(RunFolder("film.avi")));
}

TEST_F(VideoTest, RefusesWhatIsNotThere) {
  if (CannotWrite(Video("a.gif", {"--size", "16", "--to", "0"}))) GTEST_SKIP();
  EXPECT_THAT(Video("a.gif", {"--episode", "7"}).errors, HasSubstr("episode 7 is not recorded"));
  const ProgramResult late = Video("a.gif", {"--from", "5"});
  EXPECT_EQ(late.exit_status, 2);
  EXPECT_THAT(late.errors, HasSubstr("is after the end of the episode"));
  EXPECT_EQ(Video("a.gif", {"--speed", "0"}).exit_status, 2);
}

}  // namespace
}  // namespace runtime
