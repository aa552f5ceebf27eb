#include "runtime/base/pipe.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace runtime {
namespace {

bool IsOpen(int descriptor) { return fcntl(descriptor, F_GETFD) >= 0; }

TEST(PipeTest, WhatGoesInComesOut) {
  Pipe pipe;
  ASSERT_EQ(write(pipe.input(), "ab", 2), 2);
  pipe.CloseInput();
  char bytes[4] = {};
  EXPECT_EQ(read(pipe.output(), bytes, sizeof bytes), 2);
  EXPECT_STREQ(bytes, "ab");
  EXPECT_EQ(read(pipe.output(), bytes, sizeof bytes), 0);  // its end
}

TEST(PipeTest, IsClosedButForWhatWasTaken) {
  int input = -1;
  int output = -1;
  {
    Pipe pipe;
    input = pipe.TakeInput();
    output = pipe.output();
    EXPECT_EQ(pipe.input(), -1);
    EXPECT_EQ(fcntl(output, F_GETFD), FD_CLOEXEC);
  }
  EXPECT_TRUE(IsOpen(input));
  EXPECT_FALSE(IsOpen(output));
  close(input);
}

}  // namespace
}  // namespace runtime
