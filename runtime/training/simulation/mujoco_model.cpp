#include "runtime/training/simulation/mujoco_model.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>

#include "runtime/base/user_error.h"
#include "runtime/training/simulation/link_motion.h"

namespace runtime {
namespace {

constexpr double kMostFriction = 100;            // where nothing slides
constexpr const char* kGround = "ground plane";  // no link can be called so

// Of all that touch at a time; a robot has a dozen as a rule.
int MostContacts(const robot::RobotDescription& robot) {
  return 64 + 4 * static_cast<int>(robot.links.size());
}

using Text = fmt::memory_buffer;

template <class... Arguments>
void Append(Text& text, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
}

std::string Numbers(const robot::Vector3& v) { return fmt::format("{} {} {}", v[0], v[1], v[2]); }

std::string Numbers(const Eigen::Quaterniond& q) {
  return fmt::format("{} {} {} {}", q.w(), q.x(), q.y(), q.z());
}

robot::Vector3 Difference(const robot::Vector3& to, const robot::Vector3& from) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

// MuJoCo refuses moments of which one is larger than the other two together, as no body has them;
// those of a thin plate may be so by rounding.
Vector3 PossibleMoments(const Vector3& moments, const robot::Link& link) {
  constexpr double kRounding = 1e-9;
  Vector3 possible = moments;
  int largest = 0;
  moments.maxCoeff(&largest);
  const double others = moments[(largest + 1) % 3] + moments[(largest + 2) % 3];
  if (moments[largest] > others * (1 + kRounding)) {
    throw UserError(fmt::format(
        "MuJoCo cannot simulate the link `{}`: no body has the moments of inertia {:.3g}, {:.3g} "
        "and {:.3g} kg m^2, of which one is larger than the other two together; correct its "
        "`inertia`, or choose another profile",
        link.name, moments[0], moments[1], moments[2]));
  }
  possible[largest] = std::min(moments[largest], others);
  return possible;
}

void AppendInertia(const robot::Link& link, dBodyID body, Text& text) {
  const LinkInertia inertia = InertiaOf(body);
  const Vector3 moments = PossibleMoments(inertia.principal, link);
  Append(text, "<inertial pos='0 0 0' mass='{}' quat='{}' diaginertia='{} {} {}'/>", inertia.mass,
         Numbers(Eigen::Quaterniond(inertia.axes)), moments[0], moments[1], moments[2]);
}

// MuJoCo's capsules and cylinders lie along z.
Eigen::Quaterniond AlongAxis(int axis) {
  constexpr double kQuarter = std::numbers::pi / 2;
  if (axis == 0) return Eigen::Quaterniond(Eigen::AngleAxisd(kQuarter, Eigen::Vector3d::UnitY()));
  if (axis == 1) return Eigen::Quaterniond(Eigen::AngleAxisd(kQuarter, Eigen::Vector3d::UnitX()));
  return Eigen::Quaterniond::Identity();
}

std::string SizeAndType(const robot::Link& link) {
  const robot::LinkShape& shape = link.shape;
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return fmt::format("type='box' size='{} {} {}'", shape.size[0] / 2, shape.size[1] / 2,
                         shape.size[2] / 2);
    case robot::ShapeKind::kCapsule:
      return fmt::format("type='capsule' size='{} {}'", shape.radius,
                         shape.length / 2 - shape.radius);
    case robot::ShapeKind::kCylinder:
      return fmt::format("type='cylinder' size='{} {}'", shape.radius, shape.length / 2);
    case robot::ShapeKind::kSphere:
      return fmt::format("type='sphere' size='{}'", shape.radius);
    case robot::ShapeKind::kConvex:
      break;
  }
  return fmt::format("type='mesh' mesh='{}'", link.name);
}

// The points of convex links; MuJoCo makes their hull.
void AppendMeshes(const robot::RobotDescription& robot, Text& text) {
  Append(text, "<asset>\n");
  for (const robot::Link& link : robot.links) {
    if (link.shape.kind != robot::ShapeKind::kConvex) continue;
    Append(text, "<mesh name='{}' vertex='", link.name);
    for (const robot::Vector3& point : link.shape.points) Append(text, "{} ", Numbers(point));
    Append(text, "'/>\n");
  }
  Append(text, "</asset>\n");
}

void AppendShape(const robot::Link& link, Text& text) {
  const auto& [w, x, y, z] = link.shape.orientation;
  const bool has_axis = link.shape.kind == robot::ShapeKind::kCapsule ||
                        link.shape.kind == robot::ShapeKind::kCylinder;
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(w, x, y, z) * AlongAxis(has_axis ? link.shape.axis : 2);
  Append(text, "<geom name='{}' {} pos='{}' quat='{}'/>", link.name, SizeAndType(link),
         Numbers(link.shape.position), Numbers(turn));
}

// What a joint feels as inertia while its motor holds (runtime/training/simulation/joint_motor.h),
// along its coordinate.
double HeldInertia(const robot::RobotDescription& robot, const robot::Joint& joint,
                   double time_step) {
  const robot::Gains gains = robot.GainsOf(joint);
  const robot::PassiveForces& passive = joint.passive;
  const double damping = gains.damping + passive.damper;
  const double stiffness = gains.stiffness + passive.spring;
  const double inertia = passive.armature + time_step * (damping + time_step * stiffness);
  return inertia / (joint.radius * joint.radius);
}

void AppendJoint(const robot::RobotDescription& robot, const robot::Joint& joint, double time_step,
                 Text& text) {
  const bool slides = joint.kind == robot::JointKind::kSlider;
  // A positive angle turns the child by minus the angle.
  const double sign = slides ? 1 : -1;
  Append(text, "<joint name='{}' type='{}' axis='{} {} {}' armature='{}' frictionloss='{}'",
         joint.name, slides ? "slide" : "hinge", sign * joint.axis[0], sign * joint.axis[1],
         sign * joint.axis[2], HeldInertia(robot, joint, time_step),
         joint.passive.friction / joint.radius);
  if (!slides) {
    Append(text, " pos='{}'", Numbers(Difference(joint.anchor, robot.links[joint.child].position)));
  }
  if (joint.HasStops()) {
    Append(text, " limited='true' range='{} {}'", joint.low * joint.radius,
           joint.high * joint.radius);
  }
  Append(text, "/>");
}

// Writes the bodies of a robot from the base outwards.
class Bodies {
 public:
  Bodies(const robot::RobotDescription& robot, double time_step, const RobotBody& body)
      : robot_(robot), time_step_(time_step), body_(body), branches_(robot.links.size()) {
    for (const robot::Branch& branch : robot.Branches()) {
      branches_[branch.parent].push_back(branch);
    }
  }

  void AppendBase(Text& text) const {
    const robot::Link& base = robot_.links[0];
    Append(text, "<body name='{}' pos='{}'{}>", base.name, Numbers(base.position),
           robot_.has_fixed_base ? " mocap='true'" : "");
    if (!robot_.has_fixed_base) Append(text, "<freejoint/>");
    AppendRest(0, text);
  }

 private:
  void AppendChild(const robot::Branch& branch, Text& text) const {
    const robot::Link& link = robot_.links[branch.child];
    const robot::Link& parent = robot_.links[branch.parent];
    Append(text, "<body name='{}' pos='{}'>", link.name,
           Numbers(Difference(link.position, parent.position)));
    if (branch.joint >= 0) AppendJoint(robot_, robot_.joints[branch.joint], time_step_, text);
    const robot::Mount* mount = branch.mount >= 0 ? &robot_.mounts[branch.mount] : nullptr;
    if (mount != nullptr && mount->kind == robot::MountKind::kBall) {
      Append(text, "<joint name='{}' type='ball' pos='{}' armature='{}'/>", mount->name,
             Numbers(Difference(mount->anchor, link.position)), time_step_ * mount->damper);
    }
    AppendRest(branch.child, text);
  }

  void AppendRest(int link, Text& text) const {
    AppendInertia(robot_.links[link], body_.body(link), text);
    AppendShape(robot_.links[link], text);
    for (const robot::Branch& branch : branches_[link]) AppendChild(branch, text);
    Append(text, "</body>\n");
  }

  const robot::RobotDescription& robot_;
  double time_step_;
  const RobotBody& body_;
  std::vector<std::vector<robot::Branch>> branches_;  // of each link as a parent
};

void AppendPair(const std::string& first, const std::string& second, double friction, Text& text) {
  const double limited = std::min(friction, kMostFriction);
  Append(text, "<pair geom1='{}' geom2='{}' condim='{}' friction='{} {} 0 0 0'/>\n", first, second,
         friction > 0 ? 3 : 1, limited, limited);
}

void AppendPairs(const robot::RobotDescription& robot, Text& text) {
  for (size_t i = robot.has_fixed_base ? 1 : 0; i < robot.links.size(); ++i) {
    AppendPair(kGround, robot.links[i].name, robot.links[i].friction, text);
  }
  for (const auto& [i, j] : CollidingLinks(robot)) {
    const robot::Link& first = robot.links[i];
    const robot::Link& second = robot.links[j];
    AppendPair(first.name, second.name, std::min(first.friction, second.friction), text);
  }
}

MujocoModel Compile(const std::string& mjcf) {
  constexpr const char* kName = "robot.xml";
  UseMujoco();
  MemoryFiles files;
  files.Add(kName, mjcf);
  std::array<char, 1024> error{};
  MujocoModel model(mj_loadXML(kName, files.get(), error.data(), error.size()));
  if (!model) {
    std::string message = error.data();  // in two lines
    std::ranges::replace(message, '\n', ' ');
    throw UserError(fmt::format("MuJoCo cannot simulate this robot: {}", message));
  }
  return model;
}

}  // namespace

std::string Mjcf(const robot::RobotDescription& robot, const SolverSettings& settings,
                 const RobotBody& body) {
  const double h = settings.time_step;
  Text text;
  Append(text, "<mujoco model='{}'>\n<compiler angle='radian'/>\n", robot.name);
  // The ratio makes friction harder than normals, so that what holds does not creep.
  Append(text,
         "<option timestep='{}' gravity='0 0 {}' cone='elliptic' impratio='10' "
         "collision='predefined'/>\n",
         h, -settings.gravity);
  const int contacts = MostContacts(robot);
  Append(text, "<size nconmax='{}' njmax='{}'/>\n", contacts,
         3 * contacts + 2 * robot.joints.size());
  // Contacts and stops are as hard as MuJoCo lets a step have them.
  Append(text,
         "<default><geom contype='0' conaffinity='0'/><pair solref='{0} 1'/>"
         "<joint solreflimit='{0} 1'/></default>\n",
         2 * h);
  AppendMeshes(robot, text);
  Append(text, "<worldbody>\n<geom name='{}' type='plane' size='1 1 1'/>\n", kGround);
  Bodies(robot, h, body).AppendBase(text);
  Append(text, "</worldbody>\n<contact>\n");
  AppendPairs(robot, text);
  Append(text, "</contact>\n</mujoco>\n");
  return fmt::to_string(text);
}

std::shared_ptr<const mjModel> CompiledModel(const std::string& mjcf) {
  static std::mutex mutex;
  static std::map<std::string, std::weak_ptr<const mjModel>> models;
  const std::lock_guard lock(mutex);
  if (const auto known = models.find(mjcf); known != models.end()) {
    if (std::shared_ptr<const mjModel> model = known->second.lock()) return model;
  }
  // Robots that are made anew for each episode leave models that nobody asks for again.
  std::erase_if(models, [](const auto& entry) { return entry.second.expired(); });
  std::shared_ptr<const mjModel> model = Compile(mjcf);
  models[mjcf] = model;
  return model;
}

}  // namespace runtime
