// What tasks in bench/tasks compute, written by hand: what their emitted code is compared with.
#pragma once

#include <cmath>
#include <random>
#include <vector>

namespace runtime {

// What bench/tasks/observe.task shows to the learner. The sensors lie as the ABI wants them.
struct ObservationByHand {
  static constexpr int kJoints = 17;
  static constexpr int kLinks = 18;

  const double* orientation;  // w, x, y, z
  const double* velocity;
  const double* angular_velocity;
  const double* up;
  const double* angles;
  const double* joint_velocities;
  const unsigned char* contacts;
  const double* command;
  const double* rest;

  // Turns `v` by the inverse of the orientation.
  void ToBody(const double* v, double* result) const {
    const double square = orientation[0] * orientation[0] + orientation[1] * orientation[1] +
                          orientation[2] * orientation[2] + orientation[3] * orientation[3];
    const double w = orientation[0] / square;
    const double x = -orientation[1] / square;
    const double y = -orientation[2] / square;
    const double z = -orientation[3] / square;
    const double t[] = {2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]),
                        2 * (x * v[1] - y * v[0])};
    result[0] = v[0] + w * t[0] + (y * t[2] - z * t[1]);
    result[1] = v[1] + w * t[1] + (z * t[0] - x * t[2]);
    result[2] = v[2] + w * t[2] + (x * t[1] - y * t[0]);
  }

  void Observe(double* out) const {
    ToBody(velocity, out);
    ToBody(angular_velocity, out + 3);
    for (int i = 0; i < 3; ++i) out[6 + i] = up[i];
    for (int i = 0; i < 2; ++i) out[9 + i] = command[i];
    for (int i = 0; i < kJoints; ++i) out[11 + i] = angles[i] - rest[i];
    for (int i = 0; i < kJoints; ++i) out[11 + kJoints + i] = 0.1 * joint_velocities[i];
    for (int i = 0; i < kLinks; ++i) out[11 + 2 * kJoints + i] = contacts[i];
  }
};

// What bench/tasks/drawn.task draws, with a generator of the standard library.
class StartByHand {
 public:
  explicit StartByHand(unsigned seed) : random_(seed) {}

  // Changes joint angles, the base's position, yaw and velocity.
  void Draw(const std::vector<double>& low, const std::vector<double>& high,
            std::vector<double>& angles, double* position, double* yaw, double* velocity) {
    constexpr double kPi = 3.14159265358979323846;
    pose_ = Uniform(0, 1) < 0.5 ? 0 : 1;
    for (int i = 0; i < 2; ++i) position[i] += Uniform(-0.5, 0.5);
    *yaw = Uniform(-kPi, kPi);
    for (size_t i = 0; i < angles.size(); ++i) {
      const double noisy = angles[i] + Uniform(-kPi / 180, kPi / 180);
      angles[i] = std::fmin(std::fmax(noisy, low[i]), high[i]);
    }
    std::normal_distribution<double> speed(0, 0.1);
    for (int i = 0; i < 2; ++i) velocity[i] = speed(random_);
  }

  int pose() const { return pose_; }

 private:
  double Uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  std::mt19937_64 random_;
  int pose_ = 0;
};

}  // namespace runtime
