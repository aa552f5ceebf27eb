#include "runtime/analysis/robot/robot_problems.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "runtime/training/simulation/collision.h"

namespace runtime {
namespace {

// Of the robot's size. Contacts are soft: standing robots are in the ground by some hundredths of a
// millimeter, and links that rest on each other are within each other by as much.
constexpr double kDeepest = 0.01;
constexpr double kFarthest = 0.05;    // of its size, that a standing robot drifts in a second
constexpr double kMostDensity = 1e5;  // [kg/m^3]; no element has a fourth of it
constexpr double kMostChatter = 1.0;  // [rad/s]; sound robots are below 0.2

std::string Millimeters(double length) { return fmt::format("{:.3g} mm", 1000 * length); }

RobotProblem OverlapProblem(const robot::RobotDescription& robot, const HeldPose& held,
                            const Overlap& overlap) {
  const std::string& second = robot.links[static_cast<size_t>(overlap.second)].name;
  if (overlap.first == Contact::kGround) {
    return {
        fmt::format("`{}` is {} in the ground in pose `{}`", second, Millimeters(overlap.depth),
                    held.pose),
        fmt::format("raise the pose's `position`; its z may be more by {:.3g} m", overlap.depth)};
  }
  const std::string& first = robot.links[static_cast<size_t>(overlap.first)].name;
  return {
      fmt::format("`{}` and `{}` are within each other by {} in pose `{}`", first, second,
                  Millimeters(overlap.depth), held.pose),
      fmt::format("bend the pose's joints, make the shapes smaller, or let the two not collide: "
                  "`contact_exclusions = [[\"{}\", \"{}\"]]`",
                  first, second)};
}

std::vector<RobotProblem> OverlapProblems(const robot::RobotDescription& robot,
                                          const HeldPose& held) {
  std::vector<RobotProblem> problems;
  bool has_ground = false;
  for (const Overlap& overlap : held.overlaps) {  // the deepest first
    if (overlap.depth < kDeepest * held.size) break;
    const bool is_ground = overlap.first == Contact::kGround;
    if (is_ground && has_ground) continue;  // raising the robot helps all
    has_ground = has_ground || is_ground;
    problems.push_back(OverlapProblem(robot, held, overlap));
  }
  return problems;
}

RobotProblem ChatterProblem(const robot::RobotDescription& robot, const HeldPose& held) {
  const std::string& joint = robot.joints[static_cast<size_t>(held.chattering_joint)].name;
  const bool is_explicit = FindProfile(held.profile).drive == JointDrive::kTorque;
  return {fmt::format("`{}` shakes with {:.2g} rad/s while it holds pose `{}` in profile `{}`",
                      joint, held.chatter, held.pose, held.profile),
          is_explicit
              ? fmt::format("its `damping` is too much for so light a link at the steps of this "
                            "profile: use less, give the joint an `armature`, or take profile `{}`",
                            held.profile == "paper" ? "fast" : "fast-tree")
              : "use less `stiffness` and `damping`, or give the joint an `armature`"};
}

// What no body of this mass and shape has.
void CheckInertia(const robot::Link& link, const LinkProperties& properties,
                  std::vector<RobotProblem>& problems) {
  // What is more than matter can be in so small a shape is not what is in it: the shape stands for
  // another.
  if (!link.inertia || link.mass / properties.volume > kMostDensity) return;
  // All of the mass as far from the center as the shape reaches; twice that far for what a shape
  // leaves out.
  const double most = 4 * link.mass * properties.reach * properties.reach;
  if (properties.principal[2] > most) {
    problems.push_back(
        {fmt::format("the inertia of `{}`, {:.2g} kg m^2, is more than its {:.3g} kg have within "
                     "twice the {:.2g} m to which its shape reaches",
                     link.name, properties.principal[2], link.mass, properties.reach),
         "check the unit of `inertia`, kg m^2, or leave it out: then it is that of the shape"});
  } else if (properties.principal[0] < 1e-4 * most) {
    problems.push_back(
        {fmt::format("the inertia of `{}` is {:.2g} kg m^2 about one axis, as if its "
                     "{:.3g} kg were a point",
                     link.name, properties.principal[0], link.mass),
         "leave `inertia` out: then it is that of the shape; or give its joint an "
         "`armature`"});
  }
}

void CheckDensity(const robot::Link& link, const LinkProperties& properties,
                  std::vector<RobotProblem>& problems) {
  constexpr double kLeast = 1;  // [kg/m^3], about that of air
  const double density = link.mass / properties.volume;
  if (link.inertia || (density >= kLeast && density <= kMostDensity)) return;
  problems.push_back({fmt::format("`{}` has a density of {:.2g} kg/m^3", link.name, density),
                      "check the units: masses are in kg, lengths in m"});
}

void CheckMotors(const robot::RobotDescription& robot, const BodyProperties& body,
                 std::vector<RobotProblem>& problems) {
  std::vector<std::string> names;
  double strongest = 0;
  for (size_t i = 0; i < robot.joints.size(); ++i) {
    if (!body.joints[i].IsBeyondMotors()) continue;
    names.push_back(robot.joints[i].name);
    strongest = std::max(strongest, body.joints[i].strength);
  }
  if (names.empty()) return;
  problems.push_back(
      {fmt::format("the motors of `{}` could hold up {:.0f} such robots at the end of a limb",
                   fmt::join(names, "`, `"), strongest),
       "check the unit of `max_torque`, N m; a file that came from elsewhere may say 1000 where "
       "nobody knew"});
}

}  // namespace

std::vector<RobotProblem> ProblemsOf(const robot::RobotDescription& robot,
                                     const BodyProperties& body) {
  std::vector<RobotProblem> problems;
  for (size_t i = 0; i < robot.links.size(); ++i) {
    CheckDensity(robot.links[i], body.links[i], problems);
    CheckInertia(robot.links[i], body.links[i], problems);
  }
  CheckMotors(robot, body, problems);
  return problems;
}

std::vector<RobotProblem> ProblemsOf(const robot::RobotDescription& robot, const HeldPose& held) {
  std::vector<RobotProblem> problems = OverlapProblems(robot, held);
  if (!held.failure.empty()) {
    problems.push_back(
        {fmt::format("the simulation diverges {:.3f} s after pose `{}` in profile `{}`: {}",
                     held.seconds, held.pose, held.profile, held.failure),
         problems.empty() ? "use less `stiffness` and `damping`, give light links' joints an "
                            "`armature`, or take profile `fast`"
                          : "see above: what is within something else is thrown out of it"});
    return problems;
  }
  if (held.chatter > kMostChatter) problems.push_back(ChatterProblem(robot, held));
  if (held.Stands() && held.drift > kFarthest * held.size) {
    problems.push_back({fmt::format("the robot drifts by {} in a second while it holds pose `{}` "
                                    "in profile `{}`",
                                    Millimeters(held.drift), held.pose, held.profile),
                        "see whether links that touch push each other, and whether its weight is "
                        "above its feet"});
  }
  return problems;
}

}  // namespace runtime
