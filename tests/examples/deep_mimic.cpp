// Peng, Abbeel, Levine, van de Panne: DeepMimic, ACM Transactions on Graphics 37 (2018), section 5:
// the reward for imitation; xbpeng/DeepMimic, DeepMimicCore/scenes/SceneImitate.cpp: its weights,
// and the kernel of the root. Lengths and velocities are brought to this robot's size, as the task
// says.
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <vector>

#include "tests/examples/published.h"

namespace examples {
namespace {

constexpr double kSize = 0.2;
constexpr double kPace = 2;

// The columns of track.csv as they stand there: the time, the joints in degrees, the links in
// meters, the trunk's rotation, its angular velocity in degrees per second.
struct Pose {
  OfJoints angles;
  OfLinks places;
  Eigen::Quaterniond turn;
  Eigen::Vector3d spin;
};

class Motion {
 public:
  Motion() {
    std::ifstream file(SOURCE_DIR "/examples/tasks/track.csv");
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
      std::istringstream cells(line);
      std::vector<double> row;
      for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
      MakeRotation(&row[kTurn]);
      rows_.push_back(row);
    }
  }

  Pose At(double time) const {
    const double spacing = rows_[1][0];
    const double at = std::fmod(time, rows_.back()[0]) / spacing;
    const auto row = static_cast<size_t>(at);
    Pose pose;
    const auto blend = [&](int column) { return Blend(row, static_cast<size_t>(column), at); };
    constexpr double kDegree = std::numbers::pi / 180;
    for (int i = 0; i < kJoints; ++i) pose.angles[i] = blend(1 + i) * kDegree;
    for (int i = 0; i < 3 * kLinks; ++i) pose.places(i % 3, i / 3) = blend(1 + kJoints + i);
    pose.turn = {blend(kTurn), blend(kTurn + 1), blend(kTurn + 2), blend(kTurn + 3)};
    pose.turn.normalize();
    for (int i = 0; i < 3; ++i) pose.spin[i] = blend(kTurn + 4 + i) * kDegree;
    return pose;
  }

 private:
  static constexpr int kTurn = 1 + kJoints + 3 * kLinks;

  // With the few digits of the file its length is not quite 1.
  static void MakeRotation(double* turn) { Eigen::Map<Eigen::Vector4d>(turn).normalize(); }

  double Blend(size_t row, size_t column, double at) const {
    const double share = at - static_cast<double>(row);
    return (1 - share) * rows_[row][column] + share * rows_[row + 1][column];
  }

  std::vector<std::vector<double>> rows_;
};

Eigen::Vector3d CenterOf(const OfLinks& places) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double mass = 0;
  for (int i = 0; i < kLinks; ++i) {
    const double part = Humanoid().links[static_cast<size_t>(i)].mass;
    sum += part * places.col(i);
    mass += part;
  }
  return sum / mass;
}

class DeepMimic : public Published {
 public:
  void Start(const RobotState& state) override { before_ = motion_.At(state.time); }

  Payments Step(const RobotState& state, const compiler::Instance&) override {
    const Pose motion = motion_.At(state.time);
    const OfJoints velocities = (motion.angles - before_.angles) / kTimeStep;
    const double pose = (motion.angles - state.angles).square().sum();
    const double velocity = ((velocities - state.joint_velocities) / kPace).square().sum();
    double ends = 0;
    for (const char* link : {"left_hand", "right_hand", "left_foot", "right_foot"})
      ends += Miss(motion.places.col(LinkOf(link)), state.link_positions.col(LinkOf(link)));
    const double root = RootError(motion, state);
    before_ = motion;
    const double center = Miss(CenterOf(motion.places), CenterOf(state.link_positions));
    return {{"pose", 0.5 * std::exp(-2 * pose) * kTimeStep},
            {"velocity", 0.05 * std::exp(-0.1 * velocity) * kTimeStep},
            {"ends", 0.15 * std::exp(-40 * ends) * kTimeStep},
            {"trunk", 0.2 * std::exp(-5 * root) * kTimeStep},
            {"center", 0.1 * std::exp(-10 * center) * kTimeStep}};
  }

 private:
  double RootError(const Pose& motion, const RobotState& state) const {
    const int body = LinkOf("body");
    const double turn = motion.turn.angularDistance(state.orientation);
    const Eigen::Vector3d velocity =
        (motion.places.col(body) - before_.places.col(body)) / kTimeStep;
    return Miss(motion.places.col(body), state.position) + 0.1 * turn * turn +
           0.01 * Miss(velocity, state.velocity) / (kPace * kPace) +
           0.001 * ((motion.spin - state.angular_velocity) / kPace).squaredNorm();
  }

  static double Miss(const Eigen::Vector3d& wanted, const Eigen::Vector3d& place) {
    return ((wanted - place) / kSize).squaredNorm();
  }

  const Motion motion_;
  Pose before_;
};

}  // namespace

std::unique_ptr<Published> DeepMimicTrack() { return std::make_unique<DeepMimic>(); }

}  // namespace examples
