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

// Where the motion is after so many seconds, and with offsets of (0.5, 0.125).
constexpr const char* kMotionProgram = R"(#include <stdio.h>
#include "policy.h"
int main(void) {
  const double times[] = {0, 1, 1.5, 201.5};
  const float none[POLICY_TARGETS] = {0, 0};
  const float offsets[POLICY_TARGETS] = {0.5f, 0.125f};
  float targets[POLICY_TARGETS];
  for (int i = 0; i < 4; ++i) {
    policy_targets(times[i], none, targets);
    printf("%.6f %.6f, ", targets[0], targets[1]);
    policy_targets(times[i], offsets, targets);
    printf("%.6f %.6f\n", targets[0], targets[1]);
  }
  return 0;
}
)";

std::string MotionsIn(const PolicyMotion& motion) {
  const TemporaryFolder folder;
  ExportedPolicy policy = SamplePolicy();
  policy.graph.motion = motion;
  policy.graph.result.name = "joint_offsets";
  std::ofstream(folder.path() / "policy.h") << CHeaderOf(policy);
  std::ofstream(folder.path() / "program.c") << kMotionProgram;
  const std::string program = (folder.path() / "program").string();
  const ProgramResult built =
      RunProgram({"/usr/bin/env", "cc", "-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror",
                  "-Wno-unused-function", program + ".c", "-o", program, "-lm"});
  EXPECT_EQ(built.exit_status, 0) << built.errors;
  return RunProgram({program}).output;
}

// 0.25 + sin(pi t) + 0.5 cos(pi t) within 1, and -0.5 cos(pi t) within 0.25.
TEST(CHeader, PlaysAMotion) {
  EXPECT_EQ(MotionsIn(SampleMotion()),
            "0.750000 -0.250000, 1.000000 -0.125000\n"
            "-0.250000 0.250000, 0.250000 0.250000\n"
            "-0.750000 0.000000, -0.250000 0.125000\n"
            "-0.750000 0.000000, -0.250000 0.125000\n");
}

// The first joint goes from 0 to 1 in 2 s and back, with rate 0 at each knot: t^2 (3 - 2 t). The
// second passes its first knot at half of 0.25 in the time of a knot: 0.25 t^2 (3 - 2 t) - 0.125
// t^2 (1 - t).
TEST(CHeader, PlaysAMotionThatIsDoneOnce) {
  PolicyMotion motion = SampleMotion();
  motion.is_periodic = false;
  motion.frequency = 0.25;
  motion.shape = Eigen::MatrixXd{{0, 1, 0}, {0, 0.25, 0.25}};
  motion.high[0] = 2;
  EXPECT_EQ(MotionsIn(motion),
            "0.000000 0.000000, 0.500000 0.125000\n"
            "0.500000 0.109375, 1.000000 0.234375\n"
            "0.843750 0.193359, 1.343750 0.250000\n"
            "0.000000 0.250000, 0.500000 0.250000\n");
}

}  // namespace
}  // namespace runtime
