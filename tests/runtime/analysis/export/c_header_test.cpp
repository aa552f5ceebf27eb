#include "runtime/analysis/export/c_header.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/runtime/analysis/export/sample_policy.h"
#include "tests/runtime/trainer/child_process.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::HasSubstr;

constexpr const char* kProgram = R"(#include <stdio.h>
#include "policy.h"
int main(void) {
  const float observation[POLICY_OBSERVATIONS] = {0.5f, -0.5f};
  float targets[POLICY_TARGETS];
  policy_step(observation, targets);
  printf("%.6f %.6f\n", targets[POLICY_TARGET_LEFT], targets[POLICY_TARGET_RIGHT]);
  return 0;
}
)";

TEST(CHeader, SaysWhatItsNumbersAre) {
  const std::string text = CHeaderOf(SamplePolicy());
  EXPECT_THAT(text, HasSubstr("//   task       balance\n//   run        a_\n"));
  EXPECT_THAT(text, HasSubstr("every 0.04 s"));
  EXPECT_THAT(text, HasSubstr("  POLICY_OBSERVATION_TILT_PITCH,  // tilt.pitch [rad]\n"
                              "  POLICY_OBSERVATION_TILT_PITCH_2,  // tilt.pitch [rad/s]\n"));
  EXPECT_THAT(text, HasSubstr("  POLICY_TARGET_LEFT,  // left [rad]\n"));
}

// tanh(0.5 + 2 * -0.25 + 0.5), halved, and what would be less than -0.125.
TEST(CHeader, IsCompiledAsCAndAsCppAndComputesThePolicy) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "policy.h") << CHeaderOf(SamplePolicy());
  std::ofstream(folder.path() / "program.c") << kProgram;
  const std::string program = (folder.path() / "program").string();
  const auto run = [&](std::vector<std::string> compiler) {
    compiler.insert(compiler.end(), {"-Wall", "-Wextra", "-pedantic", "-Werror", program + ".c",
                                     "-o", program, "-lm"});
    const ProgramResult built = RunProgram(compiler);
    EXPECT_EQ(built.exit_status, 0) << built.errors;
    return RunProgram({program}).output;
  };
  EXPECT_EQ(run({"/usr/bin/env", "cc", "-std=c99"}), "0.231059 -0.125000\n");
  EXPECT_EQ(run({"/usr/bin/env", "c++", "-std=c++17", "-x", "c++"}), "0.231059 -0.125000\n");
}

}  // namespace
}  // namespace runtime
