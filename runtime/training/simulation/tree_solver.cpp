#include "runtime/training/simulation/tree_solver.h"

#include <algorithm>
#include <limits>

namespace runtime {
namespace {

constexpr size_t kUsualGroundContacts = 8;  // of a link with the ground
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<TreeJoint> TreeJoints(const robot::RobotDescription& robot, double hold) {
  std::vector<TreeJoint> joints;
  for (const robot::Joint& joint : robot.joints) {
    TreeJoint& added = joints.emplace_back();
    added.parent = joint.parent;
    added.child = joint.child;
    added.hold = hold;
  }
  return joints;
}

// What a spring of the same stiffness in all directions, at `arm` from the center, does to a body's
// velocities: it is the inertia of a point mass.
Matrix6 PointInertia(const Vector3& arm, double mass) {
  const Matrix3 coupling = mass * CrossMatrix(arm);
  Matrix6 inertia = Matrix6::Zero();
  inertia.topLeftCorner<3, 3>().diagonal().setConstant(mass);
  inertia.topRightCorner<3, 3>() = -coupling;
  inertia.bottomLeftCorner<3, 3>() = coupling;
  inertia.bottomRightCorner<3, 3>() = -mass * arm * arm.transpose();
  inertia.bottomRightCorner<3, 3>().diagonal().array() += mass * arm.squaredNorm();
  return inertia;
}

}  // namespace

TreeSolver::TreeSolver(const robot::RobotDescription& robot, const Profile& profile,
                       const SolverSettings& settings, RobotBody& body)
    : settings_(settings),
      drive_(profile.drive),
      hold_(settings.time_step / settings.cfm),
      body_(body),
      tree_(TreeJoints(robot, hold_)),
      links_(robot.links.size()),
      limits_(robot.joints.size()),
      link_contacts_(body.link_count()),
      velocities_(robot.links.size()),
      inertias_(robot.links.size()),
      momenta_(robot.links.size()),
      scratch_(robot.links.size()) {
  ground_contacts_.reserve(kUsualGroundContacts * robot.links.size());
  for (int i = 0; i < body.link_count(); ++i) link_inertias_.push_back(InertiaOf(body.body(i)));
  for (const robot::Joint& joint : robot.joints) {
    const Vector3 anchor = ToEigen(joint.anchor.data());
    hinges_.push_back({anchor - ToEigen(robot.links[joint.parent].position.data()),
                       anchor - ToEigen(robot.links[joint.child].position.data()),
                       ToEigen(joint.axis.data()).normalized(), joint.low, joint.high});
  }
}

void TreeSolver::Step(std::span<const Contact> contacts, const JointController& controller,
                      std::span<Vector3> impulses) {
  ReadLinks();
  for (int j = 0; j < body_.joint_count(); ++j) ReadHinge(j, controller);
  ReadContacts(contacts);
  SolveForVelocities();
  if (!impulses.empty()) AddImpulses(contacts, impulses);
  for (int i = 0; i < body_.link_count(); ++i) {
    MoveLink(body_.body(i), links_[i], velocities_[i], settings_.time_step);
  }
}

void TreeSolver::ReadLinks() {
  for (int i = 0; i < body_.link_count(); ++i) {
    links_[i] = ReadLink(body_.body(i), link_inertias_[i], settings_.time_step, settings_.gravity);
    velocities_[i] = links_[i].velocity;
  }
}

void TreeSolver::ReadHinge(int hinge, const JointController& controller) {
  const Hinge& shape = hinges_[hinge];
  TreeJoint& joint = tree_.joints()[hinge];
  const LinkState& parent = links_[joint.parent];
  const LinkState& child = links_[joint.child];
  joint.parent_arm = parent.rotation * shape.parent_anchor;
  joint.child_arm = child.rotation * shape.child_anchor;
  joint.axis = parent.rotation * shape.axis;

  // The child is drawn to where it belongs.
  HingeLimits& limits = limits_[hinge];
  const double correction = settings_.erp / settings_.time_step;
  const Vector3 gap = parent.position + joint.parent_arm - child.position - joint.child_arm;
  Vector3 tilt = (child.rotation * shape.axis).cross(joint.axis);
  tilt -= joint.axis.dot(tilt) * joint.axis;  // rounding that would turn the joint
  limits.load << gap, tilt;
  limits.load *= hold_ * correction;

  const double h = settings_.time_step;
  if (drive_ == JointDrive::kTorque) {
    limits.torque = h * controller.torques()[hinge];
  } else {
    const Motor& motor = controller.motors()[hinge];
    limits.motor.target = motor.speed;
    limits.motor.stiffness = h * motor.damping;
    limits.motor.low = -h * motor.max_torque;
    limits.motor.high = h * motor.max_torque;
  }

  const double angle = controller.angles()[hinge];
  const bool is_low = angle <= shape.low_stop;
  const bool is_high = !is_low && angle >= shape.high_stop;
  LimitedPull stop;
  if (is_low || is_high) {
    stop.target = correction * ((is_low ? shape.low_stop : shape.high_stop) - angle);
    stop.stiffness = hold_;
    (is_low ? stop.high : stop.low) = is_low ? kInfinity : -kInfinity;
    stop.state = stop.NextState(HingeSpeed(hinge));
  }
  limits.stop = stop;
}

double TreeSolver::HingeSpeed(int hinge) const {
  const TreeJoint& joint = tree_.joints()[hinge];
  return joint.axis.dot(velocities_[joint.parent].tail<3>() - velocities_[joint.child].tail<3>());
}

void TreeSolver::ReadContacts(std::span<const Contact> contacts) {
  ground_contacts_.clear();
  link_contacts_.Clear();
  for (const Contact& contact : contacts) {
    if (contact.first == Contact::kGround) {
      AddGroundContact(contact.second, -ToEigen(contact.geometry.normal), contact.geometry);
    } else if (contact.second == Contact::kGround) {
      AddGroundContact(contact.first, ToEigen(contact.geometry.normal), contact.geometry);
    } else {
      LimitedPull& pull = link_contacts_.Add(contact, links_[contact.first].position,
                                             links_[contact.second].position, hold_);
      const int index = link_contacts_.size() - 1;
      pull = NormalPull(contact.geometry.depth, link_contacts_.NormalSpeed(index, velocities_));
    }
  }
}

// The one that pushes the link up `normal`.
void TreeSolver::AddGroundContact(int link, const Vector3& normal, const dContactGeom& geometry) {
  const Vector3 arm = ToEigen(geometry.pos) - links_[link].position;
  GroundContact contact;
  contact.link = link;
  contact.row << normal, arm.cross(normal);
  contact.pull = NormalPull(geometry.depth, contact.row.dot(velocities_[link]));
  ground_contacts_.push_back(contact);
  links_[link].inertia += PointInertia(arm, hold_);
  links_[link].inertia -= hold_ * contact.row * contact.row.transpose();
}

LimitedPull TreeSolver::NormalPull(double depth, double speed) const {
  const double h = settings_.time_step;
  LimitedPull pull;
  pull.target = settings_.contacts.erp / h * depth;
  if (-speed > settings_.bounce_speed) {
    pull.target = std::max(pull.target, settings_.bounce * -speed);
  }
  pull.stiffness = h / settings_.contacts.cfm;
  pull.high = kInfinity;
  pull.state = pull.NextState(speed);
  return pull;
}

void TreeSolver::SolveForVelocities() {
  constexpr int kMostRounds = 1000;
  constexpr int kChances = 5;  // to correct all that is wrong without having less wrong
  int least_wrong = std::numeric_limits<int>::max();
  int chances = kChances;
  for (int round = 0; round < kMostRounds; ++round) {
    SolveAsAssumed();
    const int wrong = CorrectStates(chances > 0);
    if (wrong == 0) return;
    chances = wrong < least_wrong ? kChances : chances - 1;
    least_wrong = std::min(wrong, least_wrong);
  }
  throw OdeFailure("there are no impulses within their limits");
}

void TreeSolver::SolveAsAssumed() {
  for (size_t i = 0; i < links_.size(); ++i) {
    inertias_[i] = links_[i].inertia;
    momenta_[i] = links_[i].momentum;
  }
  for (const GroundContact& contact : ground_contacts_) {
    const double hold = contact.pull.hold();
    if (hold == 0) continue;
    inertias_[contact.link] += hold * contact.row * contact.row.transpose();
    momenta_[contact.link] += contact.pull.load() * contact.row;
  }
  for (size_t j = 0; j < limits_.size(); ++j) {
    const HingeLimits& limits = limits_[j];
    TreeJoint& joint = tree_.joints()[j];
    joint.hold_of_axis = limits.motor.hold() + limits.stop.hold();
    joint.load = limits.load;
    joint.load.tail<3>() -= (limits.torque + limits.motor.load() + limits.stop.load()) * joint.axis;
  }
  tree_.Factorize(inertias_);
  scratch_ = momenta_;
  tree_.Solve(scratch_, velocities_);
  if (link_contacts_.empty()) return;
  link_contacts_.AddImpulses(tree_, velocities_, momenta_);
  tree_.Solve(momenta_, velocities_);
}

void TreeSolver::AddImpulses(std::span<const Contact> contacts, std::span<Vector3> impulses) const {
  size_t ground_contact = 0;
  int link_contact = 0;
  for (const Contact& contact : contacts) {
    if (contact.first == Contact::kGround || contact.second == Contact::kGround) {
      const GroundContact& ground = ground_contacts_[ground_contact++];
      impulses[ground.link] += ImpulseOf(ground, ToEigen(contact.geometry.pos));
    } else {
      const Vector3 impulse = link_contacts_.Impulse(link_contact++, velocities_);
      impulses[contact.first] += impulse;
      impulses[contact.second] -= impulse;
    }
  }
}

// Along the normal a pull within its limits, across it what keeps the link from sliding.
Vector3 TreeSolver::ImpulseOf(const GroundContact& contact, const Vector3& point) const {
  const Vector6& velocity = velocities_[contact.link];
  const Vector3 arm = point - links_[contact.link].position;
  const double speed = contact.row.dot(velocity);
  const Vector3 sliding =
      velocity.head<3>() + velocity.tail<3>().cross(arm) - speed * contact.normal();
  return (contact.pull.load() - contact.pull.hold() * speed) * contact.normal() - hold_ * sliding;
}

int TreeSolver::CorrectStates(bool all) {
  int wrong = 0;
  LimitedPull* last = nullptr;
  auto last_state = LimitedPull::State::kSpring;
  const auto judge = [&](LimitedPull& pull, double speed) {
    const LimitedPull::State next = pull.NextState(speed);
    if (next == pull.state) return;
    ++wrong;
    last = &pull;
    last_state = next;
    if (all) pull.state = next;
  };
  for (size_t j = 0; j < limits_.size(); ++j) {
    const double speed = HingeSpeed(static_cast<int>(j));
    judge(limits_[j].motor, speed);
    judge(limits_[j].stop, speed);
  }
  for (GroundContact& contact : ground_contacts_) {
    judge(contact.pull, contact.row.dot(velocities_[contact.link]));
  }
  for (int i = 0; i < link_contacts_.size(); ++i) {
    judge(link_contacts_.pull(i), link_contacts_.NormalSpeed(i, velocities_));
  }
  if (last != nullptr) last->state = last_state;
  return wrong;
}

}  // namespace runtime
