#include "runtime/training/signal/signal_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Each test is a process of its own, and several run at a time.
const std::string kFile = testing::TempDir() + "/signal_file_test" + std::to_string(getpid());

SignalFile ReadText(const std::string& text) {
  std::ofstream(kFile) << text;
  return ReadSignalFile(kFile);
}

// What is said of a file, behind its name.
std::string MistakeIn(const std::string& text) {
  try {
    ReadText(text);
  } catch (const UserError& error) {
    const std::string what = error.what();
    return what.substr(what.find(kFile) + kFile.size());
  }
  return "none";
}

TEST(SignalFile, HasATimeAndElements) {
  const SignalFile read = ReadText("time [s], x [m/s],y [m/s]\r\n0, 1, -2\n\n 1.5 ,3e-1,4\r\n");
  EXPECT_THAT(read.samples, ElementsAre(0, 1, -2, 1.5, 0.3, 4));
  EXPECT_EQ(read.elements, 2u);
  EXPECT_EQ(read.unit, "m/s");
  EXPECT_EQ(ReadText("time [s], share\n0, 1").unit, "");
}

TEST(SignalFile, SaysWhereItIsWrong) {
  EXPECT_EQ(MistakeIn("time, x [m]\n0, 1\n"), ":1: the first heading is `time`: write `time [s]`");
  EXPECT_EQ(MistakeIn("time [s]\n0\n"), ":1: there is only a time: add a column for each element");
  EXPECT_EQ(MistakeIn("time [s], x [m], y\n0, 1, 2\n"),
            ":1: `x [m]` and `y` have two units: a sensor has one");
  EXPECT_EQ(MistakeIn("time [s], x\n0, 1\n1\n"), ":3: there are 1 columns here, and 2 headings");
  EXPECT_EQ(MistakeIn("time [s], x\n0, \n"), ":2: there is an empty cell: write a number");
  EXPECT_EQ(MistakeIn("time [s], x\n0, nan\n"), ":2: `nan` is not a finite number");
  EXPECT_EQ(MistakeIn("time [s], x\n0, 1e999\n"), ":2: `1e999` is not a finite number");
  EXPECT_EQ(MistakeIn("time [s], x\n0, 1;\n"), ":2: `1;` is not a finite number");
  EXPECT_EQ(MistakeIn("time [s], x\n0, 1\n0, 2\n"),
            ":3: the times must ascend, and this is no later than the one above");
  EXPECT_THAT(MistakeIn("time [s], x\n"), HasSubstr("there are no rows of numbers"));
  EXPECT_THAT(MistakeIn(""), HasSubstr("there are no rows of numbers"));
}

TEST(SignalFile, IsARegularFileOfModerateSize) {
  std::string large = "time [s], x\n";
  for (int i = 0; i < 100'000; ++i) large += std::to_string(i) + ", 0.1234\n";
  EXPECT_THAT(MistakeIn(large), HasSubstr("has more than 1000000 bytes"));
  const std::string pipe = kFile + ".pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(ReadSignalFile(pipe), UserError);
  std::remove(pipe.c_str());
  EXPECT_THROW(ReadSignalFile("/nowhere/x.csv"), UserError);
}

}  // namespace
}  // namespace runtime
