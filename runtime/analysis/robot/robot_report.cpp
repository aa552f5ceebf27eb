#include "runtime/analysis/robot/robot_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "plugins/robot/kind_names.h"

namespace runtime {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegrees = 180 / std::numbers::pi;

std::string StopsOf(const robot::Joint& joint) {
  if (!joint.HasStops()) return "without";
  if (joint.kind == robot::JointKind::kSlider) {
    return fmt::format("{:.3g} to {:.3g} m", joint.low * joint.radius, joint.high * joint.radius);
  }
  return fmt::format("{:.0f} to {:.0f} deg", joint.low * kDegrees, joint.high * kDegrees);
}

// Rows of words below a heading, each column as wide as its longest word.
class Table {
 public:
  void Add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  std::string Text() const {
    std::vector<size_t> widths;
    for (const auto& row : rows_) {
      widths.resize(std::max(widths.size(), row.size()));
      for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const auto& row : rows_) {
      std::string line;
      for (size_t i = 0; i < row.size(); ++i) line += fmt::format("{:<{}}  ", row[i], widths[i]);
      line.erase(line.find_last_not_of(' ') + 1);
      text += line + "\n";
    }
    return text;
  }

 private:
  std::vector<std::vector<std::string>> rows_;
};

std::string LinkTable(const RobotReport& report) {
  Table table;
  table.Add({"link", "mass (kg)", "principal inertias (kg m^2)", "density (kg/m^3)"});
  for (size_t i = 0; i < report.robot.links.size(); ++i) {
    const robot::Link& link = report.robot.links[i];
    const LinkProperties& properties = report.body.links[i];
    const Eigen::Vector3d& p = properties.principal;
    table.Add({link.name, fmt::format("{:.4g}", link.mass),
               fmt::format("{:.2e} {:.2e} {:.2e}", p[0], p[1], p[2]),
               fmt::format("{:.0f}", link.mass / properties.volume)});
  }
  return table.Text();
}

std::string JointTable(const RobotReport& report) {
  Table table;
  table.Add(
      {"joint", "type", "axis", "stops", "torque", "stiffness", "damping", "inertia", "swings at"});
  for (size_t i = 0; i < report.robot.joints.size(); ++i) {
    const robot::Joint& joint = report.robot.joints[i];
    const JointProperties& properties = report.body.joints[i];
    const robot::Gains gains = report.robot.GainsOf(joint);
    const bool has_motor = gains.HasMotor();
    const auto number = [&](double value) {
      return has_motor ? fmt::format("{:.3g}", value) : std::string("-");
    };
    table.Add({joint.name, NameOf(joint.kind),
               fmt::format("{:.2g} {:.2g} {:.2g}", joint.axis[0], joint.axis[1], joint.axis[2]),
               StopsOf(joint), number(gains.max_torque), number(gains.stiffness),
               number(gains.damping), fmt::format("{:.2e}", properties.inertia),
               has_motor ? fmt::format("{:.2g} Hz", properties.frequency) : "no motor"});
  }
  return table.Text();
}

std::string SiteTable(const RobotReport& report) {
  Table table;
  table.Add({"site", "link", "from its center (m)", "turned (w x y z)"});
  for (const robot::Site& site : report.robot.sites) {
    const robot::Vector3 arm = report.robot.ArmOf(site);
    const robot::Quaternion& q = site.orientation;
    table.Add({site.name, report.robot.links[static_cast<size_t>(site.link)].name,
               fmt::format("{:.4g} {:.4g} {:.4g}", arm[0], arm[1], arm[2]),
               fmt::format("{:.3g} {:.3g} {:.3g} {:.3g}", q[0], q[1], q[2], q[3])});
  }
  return table.Text();
}

std::string BaseText(const RobotReport& report, const HeldPose& held) {
  if (report.robot.has_fixed_base) return "its base is fixed";
  return fmt::format("{}: tilts by {:.2g} deg, sinks by {:.2g} mm, drifts by {:.2g} mm",
                     held.Stands() ? "stays" : "falls", held.tilt * kDegrees, 1000 * held.sink,
                     1000 * held.drift);
}

std::string PoseText(const RobotReport& report, const HeldPose& held) {
  std::string text = fmt::format("pose {}, held for {:.3g} s in profile {}\n", held.pose,
                                 held.seconds, held.profile);
  auto out = std::back_inserter(text);
  if (!held.failure.empty()) {
    fmt::format_to(out, "  diverges: {}\n", held.failure);
    return text;
  }
  fmt::format_to(out, "  base     {}\n", BaseText(report, held));
  if (held.chattering_joint >= 0) {
    fmt::format_to(out, "  chatter  {:.2g} rad/s in {}\n", held.chatter,
                   report.robot.joints[static_cast<size_t>(held.chattering_joint)].name);
  }
  fmt::format_to(out, "  speed    {:.0f} times real time on one core\n", held.real_time_factor);
  return text;
}

Json ToJson(const robot::RobotDescription& robot, const HeldPose& held) {
  Json overlaps = Json::array();
  for (const Overlap& overlap : held.overlaps) {
    const Json first =
        overlap.first < 0 ? Json() : Json(robot.links[static_cast<size_t>(overlap.first)].name);
    overlaps.push_back({{"first", first},
                        {"second", robot.links[static_cast<size_t>(overlap.second)].name},
                        {"depth", overlap.depth}});
  }
  Json json = {{"name", held.pose},
               {"profile", held.profile},
               {"size", held.size},
               {"seconds", held.seconds},
               {"diverged", held.failure.empty() ? Json() : Json(held.failure)},
               {"stands", held.Stands()},
               {"tilt", held.tilt},
               {"sink", held.sink},
               {"drift", held.drift},
               {"chatter", held.chatter}};
  json["chattering_joint"] =
      held.chattering_joint < 0
          ? Json()
          : Json(robot.joints[static_cast<size_t>(held.chattering_joint)].name);
  json["real_time_factor"] = held.real_time_factor;
  json["overlaps"] = overlaps;
  return json;
}

Json Finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json LinksOf(const RobotReport& report) {
  Json links = Json::array();
  for (size_t i = 0; i < report.robot.links.size(); ++i) {
    const LinkProperties& properties = report.body.links[i];
    const Eigen::Vector3d& p = properties.principal;
    links.push_back({{"name", report.robot.links[i].name},
                     {"mass", report.robot.links[i].mass},
                     {"principal_inertias", {p[0], p[1], p[2]}},
                     {"volume", properties.volume}});
  }
  return links;
}

Json JointsOf(const RobotReport& report) {
  Json joints = Json::array();
  for (size_t i = 0; i < report.robot.joints.size(); ++i) {
    const robot::Joint& joint = report.robot.joints[i];
    const robot::Gains gains = report.robot.GainsOf(joint);
    const JointProperties& properties = report.body.joints[i];
    joints.push_back({{"name", joint.name},
                      {"type", NameOf(joint.kind)},
                      {"parent", report.robot.links[static_cast<size_t>(joint.parent)].name},
                      {"child", report.robot.links[static_cast<size_t>(joint.child)].name},
                      {"axis", joint.axis},
                      {"low", Finite(joint.low)},
                      {"high", Finite(joint.high)},
                      {"stiffness", gains.stiffness},
                      {"damping", gains.damping},
                      {"max_torque", gains.max_torque},
                      {"max_speed", Finite(gains.max_speed)},
                      {"inertia", properties.inertia},
                      {"frequency", properties.frequency},
                      {"damping_ratio", properties.damping_ratio}});
  }
  return joints;
}

Json SitesOf(const robot::RobotDescription& robot) {
  Json sites = Json::array();
  for (const robot::Site& site : robot.sites) {
    sites.push_back({{"name", site.name},
                     {"link", robot.links[static_cast<size_t>(site.link)].name},
                     {"position", robot.ArmOf(site)},
                     {"orientation", site.orientation}});
  }
  return sites;
}

}  // namespace

RobotReport::RobotReport(const robot::RobotDescription& described, const Profile& profile)
    : robot(described), body(PropertiesOf(described)), problems(ProblemsOf(described, body)) {
  for (const robot::Pose& pose : robot.poses) {
    poses.push_back(HoldPose(robot, profile, pose));
    std::ranges::move(ProblemsOf(robot, poses.back()), std::back_inserter(problems));
  }
}

bool RobotReport::HasFailed() const {
  return std::ranges::any_of(poses, [](const HeldPose& held) { return !held.failure.empty(); });
}

std::string ToText(const RobotProblem& problem) {
  return fmt::format("warning: {}\n  help: {}\n", problem.text, problem.help);
}

std::string ToText(const RobotReport& report) {
  const robot::RobotDescription& robot = report.robot;
  std::string text =
      fmt::format("{}: {}\n{}\n{:.4g} kg in {} links, {} joints\n\n", robot.name, robot.doc,
                  robot.file.string(), report.body.mass, robot.links.size(), robot.joints.size());
  text += LinkTable(report) + "\n";
  if (!robot.joints.empty()) text += JointTable(report) + "\n";
  if (!robot.sites.empty()) text += SiteTable(report) + "\n";
  for (const HeldPose& held : report.poses) text += PoseText(report, held);
  for (const RobotProblem& problem : report.problems) text += "\n" + ToText(problem);
  return text;
}

Json ToJson(const RobotReport& report) {
  const robot::RobotDescription& robot = report.robot;
  Json poses = Json::array();
  for (const HeldPose& held : report.poses) poses.push_back(ToJson(robot, held));
  Json problems = Json::array();
  for (const RobotProblem& problem : report.problems)
    problems.push_back({{"text", problem.text}, {"help", problem.help}});
  return {{"name", robot.name},
          {"doc", robot.doc},
          {"file", robot.file.string()},
          {"fixed_base", robot.has_fixed_base},
          {"mass", report.body.mass},
          {"links", LinksOf(report)},
          {"joints", JointsOf(report)},
          {"sites", SitesOf(robot)},
          {"poses", poses},
          {"problems", problems}};
}

}  // namespace runtime
