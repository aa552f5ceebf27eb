#include "tests/examples/robot_state.h"

#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <stdexcept>
#include <vector>

namespace examples {
namespace {

template <class Part>
int IndexOf(const std::vector<Part>& parts, const std::string& name) {
  for (size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].name == name) return static_cast<int>(i);
  }
  throw std::runtime_error("the robot has no " + name);
}

class Draw {
 public:
  explicit Draw(std::mt19937_64& random) : random_(random) {}

  double Uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool Is(double probability) { return Uniform(0, 1) < probability; }
  Eigen::Vector3d Vector(double largest) {
    const double x = Uniform(-largest, largest);
    const double y = Uniform(-largest, largest);
    return {x, y, Uniform(-largest, largest)};
  }
  template <class Array>
  void Fill(Array& numbers, double largest) {
    for (double& number : numbers.reshaped()) number = Uniform(-largest, largest);
  }

 private:
  std::mt19937_64& random_;
};

// Turned about the vertical by any angle, then leaning by up to `largest_lean`.
Eigen::Quaterniond Orientation(Draw& draw, double largest_lean) {
  using Eigen::AngleAxisd;
  const AngleAxisd heading(draw.Uniform(-std::numbers::pi, std::numbers::pi),
                           Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d axis = draw.Vector(1).normalized();
  return Eigen::Quaterniond(heading) *
         Eigen::Quaterniond(AngleAxisd(draw.Uniform(0, largest_lean), axis));
}

double ContactProbability(const std::string& link) {
  if (link == "body" || link == "head") return 0.02;
  return link.ends_with("foot") ? 0.6 : 0.1;
}

std::vector<double> ListOf(const auto& numbers) {
  const auto list = numbers.reshaped();
  return {list.begin(), list.end()};
}

std::vector<double> RowsOf(const Eigen::Matrix3d& matrix) {
  return ListOf(Eigen::Matrix3d(matrix.transpose()));
}

// Brings what was drawn around the origin to around where the links are in the first pose, nearer.
void PlaceAsStanding(OfLinks& places) {
  const robot::Vector3& base = Humanoid().poses.front().position;
  for (int i = 0; i < kLinks; ++i) {
    const robot::Vector3& link = Humanoid().links[static_cast<size_t>(i)].position;
    for (size_t k = 0; k < 3; ++k) {
      double& place = places(static_cast<int>(k), i);
      place = base[k] + link[k] + 0.1 * place;
    }
  }
}

std::vector<double> ContactsOf(const RobotState& state) {
  std::vector<double> contacts;
  for (int i = 0; i < kLinks; ++i) contacts.push_back(state.Touches(i) ? 1 : 0);
  return contacts;
}

}  // namespace

const robot::RobotDescription& Humanoid() {
  static const robot::RobotDescription robot =
      robot::ReadRobot(SOURCE_DIR "/plugins/humanoid/robot.toml");
  return robot;
}

int LinkOf(const std::string& name) { return IndexOf(Humanoid().links, name); }
int JointOf(const std::string& name) { return IndexOf(Humanoid().joints, name); }

RobotState RandomState(std::mt19937_64& random, double time) {
  Draw draw(random);
  const bool stands = draw.Is(0.35);
  RobotState state;
  state.time = time;
  state.position = draw.Vector(0.7);
  state.position.z() = stands ? draw.Uniform(0.22, 0.26) : draw.Uniform(0.12, 0.25);
  state.orientation = Orientation(draw, stands ? 0.15 : 2);
  state.velocity = draw.Vector(0.5);
  state.angular_velocity = draw.Vector(2);
  draw.Fill(state.link_positions, 0.4);
  if (stands) PlaceAsStanding(state.link_positions);
  draw.Fill(state.link_velocities, 0.7);
  for (int i = 0; i < kLinks; ++i) {
    const bool touches = draw.Is(ContactProbability(Humanoid().links[static_cast<size_t>(i)].name));
    state.contact_forces.col(i) = draw.Vector(touches ? 6 : 0.3);
  }
  for (int i = 0; i < kJoints; ++i) {
    const robot::Joint& joint = Humanoid().joints[static_cast<size_t>(i)];
    state.angles[i] = stands ? draw.Uniform(-0.5, 0.3) : draw.Uniform(joint.low, joint.high);
  }
  draw.Fill(state.joint_velocities, 10);
  draw.Fill(state.joint_accelerations, 300);
  draw.Fill(state.torques, 1.029);
  draw.Fill(state.targets, 0.5);
  state.wish = draw.Uniform(-0.5, 0.5);
  draw.Fill(state.leader, 3);
  return state;
}

void Sense(const RobotState& state, const taskc_plugin& plugin, compiler::Instance& instance) {
  const Eigen::Matrix3d rotation = state.orientation.toRotationMatrix();
  const Eigen::Quaterniond& q = state.orientation;
  const std::map<std::string, std::vector<double>> sensors = {
      {"time", {state.time}},
      {"base.position", ListOf(state.position)},
      {"base.orientation", {q.w(), q.x(), q.y(), q.z()}},
      {"base.rotation", RowsOf(rotation)},
      {"base.forward", ListOf(rotation.col(0))},
      {"base.left", ListOf(rotation.col(1))},
      {"base.up", ListOf(rotation.col(2))},
      {"base.velocity", ListOf(state.velocity)},
      {"base.angular_velocity", ListOf(state.angular_velocity)},
      {"link.position", ListOf(state.link_positions)},
      {"link.velocity", ListOf(state.link_velocities)},
      {"contact", ContactsOf(state)},
      {"contact_force", ListOf(state.contact_forces)},
      {"joint.angle", ListOf(state.angles)},
      {"joint.velocity", ListOf(state.joint_velocities)},
      {"joint.acceleration", ListOf(state.joint_accelerations)},
      {"joint.torque", ListOf(state.torques)},
      {"joint.target", ListOf(state.targets)},
      {"wish", {state.wish}},
      {"leader.position", ListOf(state.leader)},
  };
  for (const taskc_sensor& sensor : std::span(plugin.sensors, plugin.sensor_count)) {
    if (sensor.read_by == 1u << TASKC_OBSERVE) continue;
    instance.Sense(sensor.name, sensors.at(sensor.name));
  }
}

}  // namespace examples
