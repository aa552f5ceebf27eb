// One action of DCOB (Yamaguchi, Takamatsu and Ogasawara, 2013): a smooth motion of the coordinates
// toward the center of a basis function, cut short where the next basis function begins.
//
//   T    = interval * max_j |target_j - start_j|      time of the full motion [s]
//   T_N  = scale * (d_N / D) * T  where d_N < D,  else T
//   q(t) = start + (target - start) * (1 - (1 - t / T)^3)
//
// The rates are 0 at T, and so are the accelerations; the measured rates at the start are not used.
// The motion lasts max(1, floor(T_N / dt)) time steps, and never past T. It is not watched
// whether the robot reaches the target.
#pragma once

#include <Eigen/Core>

namespace runtime {

class DcobMotion {
 public:
  explicit DcobMotion(int coordinates = 0);

  // A motion of the coordinates from `start` to `target` [rad]. `interval` [s/rad] > 0. `distance`
  // is D, from here to the target; `neighbor_distance` is d_N, how far the basis functions around
  // here lie apart; `scale` >= 0. A target that equals the start (T = 0) takes one time step, in
  // which the coordinates are held. Allocates nothing.
  void Start(const Eigen::VectorXd& start, const Eigen::VectorXd& target, double interval,
             double distance, double neighbor_distance, double scale);

  double full_time() const { return full_time_; }  // T [s]
  double duration() const { return duration_; }    // T_N [s]

  // The coordinates that this time step commands: those of the moment when it starts, so that
  // the first command of each motion is its start, to the last bit.
  const Eigen::VectorXd& Command();

  // A step of `time_step` seconds has passed. Returns whether the motion is over.
  bool Advance(double time_step);

 private:
  Eigen::VectorXd start_;
  Eigen::VectorXd way_;  // target - start
  Eigen::VectorXd command_;
  double full_time_ = 0;
  double duration_ = 0;
  double elapsed_ = 0;
};

}  // namespace runtime
