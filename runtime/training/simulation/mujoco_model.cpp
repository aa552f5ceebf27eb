#include "runtime/training/simulation/mujoco_model.h"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <utility>

#include "runtime/base/user_error.h"
#include "runtime/training/simulation/mjcf_surroundings.h"

namespace runtime {
namespace {

// Of all that touch at a time; a robot has a dozen as a rule. On hills there are more of them: with
// each piece of the ground below.
int MostContacts(const RobotBody& body, bool has_hills) {
  return 64 + (has_hills ? 16 : 4) * body.body_count();
}

robot::Vector3 Difference(const robot::Vector3& to, const robot::Vector3& from) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

// The points of convex links; MuJoCo makes their hull.
void AppendMeshes(const robot::RobotDescription& robot, MjcfText& text) {
  for (const robot::Link& link : robot.links) {
    if (link.shape.kind != robot::ShapeKind::kConvex) continue;
    Append(text, "<mesh name='{}' vertex='", link.name);
    for (const robot::Vector3& point : link.shape.points) Append(text, "{} ", Numbers(point));
    Append(text, "'/>\n");
  }
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
                 MjcfText& text) {
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

void AppendSite(const robot::RobotDescription& robot, const robot::Site& site, MjcfText& text) {
  const robot::Quaternion& q = site.orientation;
  Append(text, "<site name='{}' pos='{}' quat='{} {} {} {}'/>", site.name,
         Numbers(robot.ArmOf(site)), q[0], q[1], q[2], q[3]);
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

  void AppendBase(MjcfText& text) const {
    const robot::Link& base = robot_.links[0];
    Append(text, "<body name='{}' pos='{}'{}>", base.name, Numbers(base.position),
           robot_.has_fixed_base ? " mocap='true'" : "");
    if (!robot_.has_fixed_base) Append(text, "<freejoint/>");
    AppendRest(0, text);
  }

 private:
  void AppendChild(const robot::Branch& branch, MjcfText& text) const {
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

  void AppendRest(int link, MjcfText& text) const {
    AppendInertia(robot_.links[link].name, body_.body(link), text);
    AppendShape(robot_.links[link].name, robot_.links[link].shape, text);
    for (const robot::Site& site : robot_.sites) {
      if (site.link == link) AppendSite(robot_, site, text);
    }
    for (const robot::Branch& branch : branches_[link]) AppendChild(branch, text);
    Append(text, "</body>\n");
  }

  const robot::RobotDescription& robot_;
  double time_step_;
  const RobotBody& body_;
  std::vector<std::vector<robot::Branch>> branches_;  // of each link as a parent
};

void AppendPairsOfLinks(const robot::RobotDescription& robot, MjcfText& text) {
  for (const auto& [i, j] : CollidingLinks(robot)) {
    const robot::Link& first = robot.links[i];
    const robot::Link& second = robot.links[j];
    AppendPair(first.name, second.name, std::min(first.friction, second.friction), text);
  }
}

MujocoModel Compile(const Mjcf& mjcf) {
  constexpr const char* kName = "robot.xml";
  UseMujoco();
  MemoryFiles files;
  files.Add(kName, mjcf.text);
  if (!mjcf.hills.empty()) files.Add(kHillsFile, mjcf.hills);
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

Mjcf MjcfOf(const robot::RobotDescription& robot, const Surroundings& around,
            const SolverSettings& settings, const RobotBody& body) {
  std::string hills = HillsFile(around);
  const double h = settings.time_step;
  MjcfText text;
  Append(text, "<mujoco model='{}'>\n<compiler angle='radian'/>\n", robot.name);
  // The ratio makes friction harder than normals, so that what holds does not creep.
  Append(text,
         "<option timestep='{}' gravity='0 0 {}' cone='elliptic' impratio='10' "
         "collision='predefined'/>\n",
         h, -settings.gravity);
  const int contacts = MostContacts(body, !hills.empty());
  Append(text, "<size nconmax='{}' njmax='{}'/>\n", contacts,
         3 * contacts + 2 * robot.joints.size());
  // Contacts and stops are as hard as MuJoCo lets a step have them.
  Append(text,
         "<default><geom contype='0' conaffinity='0'/><pair solref='{0} 1'/>"
         "<joint solreflimit='{0} 1'/></default>\n",
         2 * h);
  Append(text, "<asset>\n");
  AppendMeshes(robot, text);
  AppendAssets(around, text);
  Append(text, "</asset>\n<worldbody>\n");
  AppendGround(around, text);
  Bodies(robot, h, body).AppendBase(text);
  AppendThings(around, body, text);
  Append(text, "</worldbody>\n<contact>\n");
  AppendPairs(robot, around, text);
  AppendPairsOfLinks(robot, text);
  Append(text, "</contact>\n</mujoco>\n");
  return {fmt::to_string(text), std::move(hills)};
}

std::shared_ptr<const mjModel> CompiledModel(const Mjcf& mjcf) {
  static std::mutex mutex;
  static std::map<Mjcf, std::weak_ptr<const mjModel>> models;
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
