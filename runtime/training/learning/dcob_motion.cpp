#include "runtime/training/learning/dcob_motion.h"

#include <algorithm>
#include <cassert>

namespace runtime {

DcobMotion::DcobMotion(int coordinates)
    : start_(Eigen::VectorXd::Zero(coordinates)),
      way_(Eigen::VectorXd::Zero(coordinates)),
      command_(Eigen::VectorXd::Zero(coordinates)) {}

void DcobMotion::Start(const Eigen::VectorXd& start, const Eigen::VectorXd& target, double interval,
                       double distance, double neighbor_distance, double scale) {
  assert(start.size() == start_.size() && target.size() == start_.size() && start.size() > 0);
  start_ = start;
  way_ = target - start;
  elapsed_ = 0;
  full_time_ = interval * way_.lpNorm<Eigen::Infinity>();
  // d_N < D implies D > 0, since distances between basis functions are not negative.
  duration_ = neighbor_distance < distance ? scale * (neighbor_distance / distance) * full_time_
                                           : full_time_;
}

const Eigen::VectorXd& DcobMotion::Command() {
  const double remaining =
      full_time_ > 0 ? 1 - std::min(1.0, elapsed_ / full_time_) : 0;  // part of T
  command_ = start_ + (1 - remaining * remaining * remaining) * way_;
  return command_;
}

bool DcobMotion::Advance(double time_step) {
  elapsed_ += time_step;
  const bool goes_on = duration_ - elapsed_ >= time_step && elapsed_ < full_time_;
  return !goes_on;  // also where a time is not a number
}

}  // namespace runtime
