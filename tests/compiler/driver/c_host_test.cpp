// The example of a host, in plain C.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "compiler/toolchain/file_io.h"
#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

constexpr const char* kExample = SOURCE_DIR "/examples/host/balance";

// Of four steps of half a second, with the pole at 0.3, 0.6, 0.9 and 1.2 rad; from the second on
// the wish is 0.5 m away, from the third on something holds the pole.
TEST(CHost, FillsTheSensorsThatATaskDeclares) {
  TaskcProcess taskc;
  taskc.Write("balance.task", ReadWholeFile(std::string(kExample) + ".task").value());
  ASSERT_EQ(taskc.Run("build balance.task -o balance.so").status, 0);
  const std::string host = taskc.path("balance").string();
  const std::string compile =
      std::string("cc -std=c99 -Wall -Wextra -pedantic -Werror -I " SOURCE_DIR "/plugins/abi ") +
      kExample + ".c -o " + host + " -ldl";
  ASSERT_EQ(std::system(compile.c_str()), 0);
  const std::string out = taskc.path("out").string();
  const std::string run = host + " " + taskc.path("balance.so").string() + " > " + out;
  ASSERT_EQ(std::system(run.c_str()), 0);
  EXPECT_EQ(ReadWholeFile(out),
            "1: 0.477668\n2: 0.162668\n3: -0.439195\n4: -0.568821, falls over\n"
            "upright: 1.382320\nnear: -0.750000\nheld: -1.000000\n");
}

}  // namespace
}  // namespace compiler
