#include "runtime/core/task/task_start.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

constexpr double kSpare = 1e-6;  // that an angle may be beyond its stop [rad]

// The angles by which a pose is turned about the world's axes.
struct Turn {
  double roll = 0;
  double pitch = 0;
  double yaw = 0;
};

// Where the state keeps a value that tasks draw, or an empty span for a name that no task has.
std::span<double> ElementsIn(robot::StartState& state, Turn& turn, std::string_view name) {
  if (name == "joint.angle") return state.pose.joint_angles;
  if (name == "joint.velocity") return state.joint_velocities;
  if (name == "base.position") return state.pose.position;
  if (name == "base.velocity") return state.velocity;
  if (name == "base.angular_velocity") return state.angular_velocity;
  if (name == "base.roll") return {&turn.roll, 1};
  if (name == "base.pitch") return {&turn.pitch, 1};
  if (name == "base.yaw") return {&turn.yaw, 1};
  return {};
}

robot::Quaternion Turned(const robot::Quaternion& by_pose, const Turn& turn) {
  // Without rounding where nothing turns.
  if (turn.roll == 0 && turn.pitch == 0 && turn.yaw == 0) return by_pose;
  const Eigen::Quaterniond turned =
      Eigen::Quaterniond(Eigen::AngleAxisd(turn.yaw, Eigen::Vector3d::UnitZ()) *
                         Eigen::AngleAxisd(turn.pitch, Eigen::Vector3d::UnitY()) *
                         Eigen::AngleAxisd(turn.roll, Eigen::Vector3d::UnitX())) *
      Eigen::Quaterniond(by_pose[0], by_pose[1], by_pose[2], by_pose[3]);
  return {turned.w(), turned.x(), turned.y(), turned.z()};
}

void CheckStops(const taskc_plugin& table, const robot::StartState& state,
                const robot::RobotDescription& robot) {
  for (size_t i = 0; i < robot.joints.size(); ++i) {
    const robot::Joint& joint = robot.joints[i];
    const double angle = state.pose.joint_angles[i];
    if (angle >= joint.low - kSpare && angle <= joint.high + kSpare) continue;
    throw UserError(
        fmt::format("{}: `{}` starts at {:.6g} rad, and its stops are at {:.6g} and {:.6g} rad: "
                    "build the task again for this robot with `taskc build`",
                    table.sources[0].file, joint.name, angle, joint.low, joint.high));
  }
}

}  // namespace

std::optional<robot::StartState> DrawStart(host::TaskFrame& host,
                                           const robot::RobotDescription& robot, uint32_t attempt) {
  const taskc_plugin& table = host.plugin();
  if (table.pose_count == 0) return std::nullopt;
  const auto drawn = static_cast<uint32_t>(std::max(host.DrawPose(), 0));
  const robot::Pose& pose =
      *robot.FindPose(table.poses[std::min(drawn, table.pose_count - 1)].name);
  robot::StartState state = robot::RestIn(pose);
  Turn turn;
  const std::span values(table.start_values, table.start_value_count);
  for (const taskc_start_value& value : values) {
    std::ranges::copy(ElementsIn(state, turn, value.name), host.Elements(value).begin());
  }
  host.DrawStart(attempt);
  for (const taskc_start_value& value : values) {
    const std::span<double> elements = host.Elements(value);
    if (!std::ranges::all_of(elements, [](double x) { return std::isfinite(x); })) {
      throw UserError(fmt::format("{}: the start's `{}` is not finite: limit what it is drawn from",
                                  table.sources[0].file, value.name));
    }
    std::ranges::copy(elements, ElementsIn(state, turn, value.name).begin());
  }
  state.pose.orientation = Turned(pose.orientation, turn);
  CheckStops(table, state, robot);
  return state;
}

}  // namespace runtime
