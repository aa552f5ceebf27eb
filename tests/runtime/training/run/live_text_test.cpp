#include "runtime/training/run/live_text.h"

#include <gmock/gmock.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

#include "base/text/utf8.h"
#include "tests/terminal.h"

namespace runtime {
namespace {

constexpr int kTimeout = 20000;  // [ms]
const std::vector<LineField> kFields = {{"one 1.25", 0}, {"two 2.5", 2}, {"three 3.75", 1}};

TEST(FittingLine, DropsWholeFieldsByTheirRanks) {
  EXPECT_EQ(FittingLine(kFields, kAnyWidth), "one 1.25  two 2.5  three 3.75");
  EXPECT_EQ(FittingLine(kFields, 29), "one 1.25  two 2.5  three 3.75");
  EXPECT_EQ(FittingLine(kFields, 28), "one 1.25  three 3.75");
  EXPECT_EQ(FittingLine(kFields, 19), "one 1.25  two 2.5");
  EXPECT_EQ(FittingLine(kFields, 16), "one 1.25");
  EXPECT_EQ(FittingLine(kFields, 7), "two 2.5");
  EXPECT_EQ(FittingLine(kFields, 6), "");
}

TEST(FittingLine, CountsCharactersNotBytes) {
  EXPECT_EQ(text::DisplayWidth("…früh"), 5u);
  EXPECT_EQ(FittingLine({{"…früh", 0}}, 5), "…früh");
}

// A terminal, and a LiveText on it.
class LiveTextTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!HasTerminals()) GTEST_SKIP() << "there are no terminals here";
    unsetenv("NO_COLOR");
    setenv("TERM", "xterm", 1);
    int program = -1;
    const winsize size{24, 40, 0, 0};
    ASSERT_EQ(openpty(&terminal_, &program, nullptr, nullptr, &size), 0);
    output_ = fdopen(program, "w");
  }
  void TearDown() override {
    if (output_ != nullptr) std::fclose(output_);
    if (terminal_ >= 0) close(terminal_);
  }
  void Narrow(unsigned short columns) const {
    const winsize size{24, columns, 0, 0};
    ioctl(terminal_, TIOCSWINSZ, &size);
  }
  // A terminal hands on what was printed in parts, each when it comes to it.
  void ExpectPrinted(const std::string& expected) const {
    std::string printed;
    pollfd readable = {terminal_, POLLIN, 0};
    while (printed.size() < expected.size() && poll(&readable, 1, kTimeout) == 1) {
      char bytes[1000];
      const ssize_t size = read(terminal_, bytes, sizeof bytes);
      if (size <= 0) break;
      printed.append(bytes, static_cast<size_t>(size));
    }
    EXPECT_EQ(printed, expected);
  }

  int terminal_ = -1;
  std::FILE* output_ = nullptr;
};

TEST_F(LiveTextTest, TakesThePlaceOfWhatWasShown) {
  LiveText text(output_);
  EXPECT_TRUE(text.is_on_terminal());
  EXPECT_EQ(text.columns(), 39u);
  EXPECT_EQ(text.rows(), 24u);
  text.Show("a\nb\n");
  ExpectPrinted("a\x1b[K\r\nb\x1b[K\r\n");
  text.Show("c\n");
  ExpectPrinted("\x1b[2A\rc\x1b[K\r\n\x1b[K\r\n\x1b[1A");
  text.Erase();
  ExpectPrinted("\x1b[1A\r\x1b[K\r\n\x1b[1A");
  text.Show("d\n");
  ExpectPrinted("d\x1b[K\r\n");
}

TEST_F(LiveTextTest, LeavesWhatIsToStay) {
  LiveText text(output_);
  text.Show("a\n");
  text.Leave();
  text.Show("b\n");
  text.Show("c\n");
  ExpectPrinted("a\x1b[K\r\nb\x1b[K\r\n\x1b[1A\rc\x1b[K\r\n");
}

TEST_F(LiveTextTest, ReplacesNothingWhereThatIsNotWanted) {
  const LiveText text(output_, false);
  EXPECT_FALSE(text.is_on_terminal());
  EXPECT_EQ(text.columns(), kAnyWidth);
  EXPECT_EQ(text.rows(), kAnyWidth);
}

// The terminal has wrapped the 30 characters into three rows, the 10 into one and the empty line
// into one.
TEST_F(LiveTextTest, ErasesWhatANarrowerWindowHasWrapped) {
  LiveText text(output_);
  text.Show(std::string(30, 'x') + "\n" + std::string(10, 'y') + "\n\n");
  ExpectPrinted(std::string(30, 'x') + "\x1b[K\r\n" + std::string(10, 'y') +
                "\x1b[K\r\n\x1b[K\r\n");
  Narrow(11);
  EXPECT_EQ(text.columns(), 10u);
  text.Show("z\n");
  ExpectPrinted("\x1b[5A\rz\x1b[K\r\n\x1b[K\r\n\x1b[K\r\n\x1b[K\r\n\x1b[K\r\n\x1b[4A");
}

TEST(LiveText, HasRoomForEverythingWithoutATerminal) {
  std::FILE* file = std::tmpfile();
  const LiveText text(file);
  EXPECT_FALSE(text.is_on_terminal());
  EXPECT_EQ(text.columns(), kAnyWidth);
  EXPECT_EQ(text.rows(), kAnyWidth);
  std::fclose(file);
}

}  // namespace
}  // namespace runtime
