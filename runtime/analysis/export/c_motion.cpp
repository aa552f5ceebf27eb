#include "runtime/analysis/export/c_motion.h"

#include <fmt/format.h>

#include "runtime/analysis/export/c_text.h"

namespace runtime {
namespace {

// The phase is computed in double precision: an episode has many periods.
constexpr const char* kPeriodicBasis = R"(
static inline void policy_motion_basis(double seconds, float basis[]) {
  const double turns = POLICY_MOTION_FREQUENCY * seconds;
  const double angle = 6.283185307179586 * (turns - floor(turns));
  basis[0] = 1;
  for (int i = 1; i + 1 < POLICY_MOTION_COLUMNS; i += 2) {
    basis[i] = (float)sin((i + 1) / 2 * angle);
    basis[i + 1] = (float)cos((i + 1) / 2 * angle);
  }
}
)";

// A Catmull-Rom spline; what would be added to a knot before the first or behind the last belongs
// to an end, where the rate is 0.
constexpr const char* kSplineBasis = R"(
static inline void policy_motion_basis(double seconds, float basis[]) {
  const int knots = POLICY_MOTION_COLUMNS - 1;
  const double turns = POLICY_MOTION_FREQUENCY * seconds;
  const double place = (turns < 1 ? turns : 1) * knots;
  const int i = place < knots ? (int)place : knots - 1;
  const float t = (float)(place - i);
  const float from = (1 + 2 * t) * (1 - t) * (1 - t);
  const float from_rate = t * (1 - t) * (1 - t), to_rate = t * t * (t - 1);
  for (int k = 0; k < POLICY_MOTION_COLUMNS; ++k) basis[k] = 0;
  basis[i] = from;
  basis[i + 1] = 1 - from;
  if (i > 0) {
    basis[i + 1] += from_rate / 2;
    basis[i - 1] -= from_rate / 2;
  }
  if (i + 1 < knots) {
    basis[i + 2] += to_rate / 2;
    basis[i] -= to_rate / 2;
  }
}
)";

constexpr const char* kTargets = R"(
static inline float policy_within_stops(int joint, float target) {
  const float low = policy_motion_low[joint], high = policy_motion_high[joint];
  return target < low ? low : target > high ? high : target;
}

static inline void policy_targets(double seconds, const float joint_offsets[],
                                  float joint_targets[]) {
  float basis[POLICY_MOTION_COLUMNS];
  policy_motion_basis(seconds, basis);
  for (int i = 0; i < POLICY_TARGETS; ++i) {
    float target = 0;
    for (int k = 0; k < POLICY_MOTION_COLUMNS; ++k)
      target += policy_motion_shape[i * POLICY_MOTION_COLUMNS + k] * basis[k];
    joint_targets[i] = policy_within_stops(i, policy_within_stops(i, target) + joint_offsets[i]);
  }
}
)";

}  // namespace

std::string CMotion(const PolicyMotion& motion) {
  const Eigen::VectorXf rows = motion.shape.transpose().reshaped().cast<float>();
  return fmt::format(
             "\n#define POLICY_MOTION_FREQUENCY {:#.17g} /* [Hz] */\n"
             "#define POLICY_MOTION_COLUMNS {}\n",
             motion.frequency, motion.shape.cols()) +
         CArray("policy_motion_shape", rows) +
         CArray("policy_motion_low", motion.low.cast<float>()) +
         CArray("policy_motion_high", motion.high.cast<float>()) +
         (motion.is_periodic ? kPeriodicBasis : kSplineBasis) + kTargets;
}

}  // namespace runtime
