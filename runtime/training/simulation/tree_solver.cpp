#include "runtime/training/simulation/tree_solver.h"

#include <algorithm>
#include <limits>

#include "runtime/training/simulation/friction.h"

namespace runtime {
namespace {

constexpr size_t kUsualGroundContacts = 8;  // of a link with the ground
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// `hold`: the stiffness of what a joint does not leave free.
std::vector<TreeJoint> TreeJoints(const robot::RobotDescription& robot,
                                  const std::vector<robot::Branch>& branches,
                                  const SolverSettings& settings, double hold) {
  std::vector<TreeJoint> joints;
  for (const robot::Branch& branch : branches) {
    TreeJoint& added = joints.emplace_back();
    added.free = MakeGeometry(robot, branch)->Free();
    added.parent = branch.parent;
    added.child = branch.child;
    added.hold = hold;
    if (branch.mount >= 0) {
      added.hold_of_free = settings.time_step * robot.mounts[branch.mount].damper;
    }
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

TreeSolver::TreeSolver(const robot::RobotDescription& robot, const SolverSettings& settings,
                       const JointController& controller, RobotBody& body)
    : settings_(settings),
      hold_(settings.time_step / settings.cfm),
      body_(body),
      branches_(robot.Branches()),
      tree_(TreeJoints(robot, branches_, settings, hold_), robot.has_fixed_base,
            body.body_count() - body.link_count()),
      loads_(branches_.size()),
      links_(body.body_count()),
      forces_(robot.joints.size()),
      link_contacts_(body.body_count()),
      velocities_(links_.size()),
      inertias_(links_.size()),
      momenta_(links_.size()),
      scratch_(links_.size()) {
  ground_contacts_.reserve(kUsualGroundContacts * links_.size());
  for (int i = 0; i < body.body_count(); ++i) link_inertias_.push_back(InertiaOf(body.body(i)));
  for (size_t b = 0; b < branches_.size(); ++b) {
    geometries_.push_back(MakeGeometry(robot, branches_[b]));
    const int index = branches_[b].joint;
    if (index < 0) continue;
    const robot::Joint& joint = robot.joints[index];
    forces_[index] = {.branch = b,
                      .radius = joint.radius,
                      .low_stop = joint.low,
                      .high_stop = joint.high,
                      .pulls = std::vector<LimitedPull>(controller.pulls(index).size())};
  }
}

void TreeSolver::Step(std::span<const Contact> contacts, const JointController& controller,
                      std::span<Vector3> impulses) {
  ReadLinks();
  for (size_t b = 0; b < branches_.size(); ++b) ReadBranch(b);
  for (int j = 0; j < body_.joint_count(); ++j) ReadForces(j, controller);
  ReadContacts(contacts);
  SolveForVelocities();
  if (!impulses.empty()) AddImpulses(contacts, impulses);
  for (int i = 0; i < body_.body_count(); ++i) {
    MoveLink(body_.body(i), links_[i], velocities_[i], settings_.time_step);
  }
}

void TreeSolver::ReadLinks() {
  for (int i = 0; i < body_.body_count(); ++i) {
    links_[i] = ReadLink(body_.body(i), link_inertias_[i], settings_.time_step, settings_.gravity);
    velocities_[i] = links_[i].velocity;
  }
}

// The child is drawn to where it belongs.
void TreeSolver::ReadBranch(size_t branch) {
  TreeJoint& joint = tree_.joints()[branch];
  const double correction = settings_.erp / settings_.time_step;
  loads_[branch] = geometries_[branch]->Read(links_[joint.parent], links_[joint.child], joint);
  loads_[branch] *= hold_ * correction;
}

void TreeSolver::ReadForces(int joint, const JointController& controller) {
  JointForces& forces = forces_[joint];
  const double h = settings_.time_step;
  const double radius = forces.radius;
  if (!controller.has_motors()) forces.impulse = h * controller.torques()[joint] / radius;
  const std::span<const Motor> motors = controller.pulls(joint);
  for (size_t i = 0; i < motors.size(); ++i) {
    LimitedPull& pull = forces.pulls[i];
    pull.target = motors[i].speed * radius;
    pull.stiffness = h * motors[i].damping / (radius * radius);
    pull.low = -h * motors[i].max_torque / radius;
    pull.high = h * motors[i].max_torque / radius;
  }
  forces.stop = StopPull(forces, controller.angles()[joint]);
}

LimitedPull TreeSolver::StopPull(const JointForces& forces, double angle) const {
  const double correction = settings_.erp / settings_.time_step;
  const bool is_low = angle <= forces.low_stop;
  const bool is_high = !is_low && angle >= forces.high_stop;
  LimitedPull stop;
  if (is_low || is_high) {
    const double beyond = (is_low ? forces.low_stop : forces.high_stop) - angle;
    stop.target = correction * beyond * forces.radius;
    stop.stiffness = hold_;
    (is_low ? stop.high : stop.low) = is_low ? kInfinity : -kInfinity;
    stop.state = stop.NextState(SpeedOf(forces));
  }
  return stop;
}

double TreeSolver::SpeedOf(const JointForces& forces) const {
  return geometries_[forces.branch]->Speed(tree_.joints()[forces.branch], velocities_);
}

void TreeSolver::ReadContacts(std::span<const Contact> contacts) {
  ground_contacts_.clear();
  ground_frictions_.clear();
  link_contacts_.Clear();
  for (const Contact& contact : contacts) {
    if (contact.first == Contact::kGround) {
      AddGroundContact(contact.second, -ToEigen(contact.geometry.normal), contact);
    } else if (contact.second == Contact::kGround) {
      AddGroundContact(contact.first, ToEigen(contact.geometry.normal), contact);
    } else {
      LimitedPull& pull = link_contacts_.Add(contact, links_[contact.first].position,
                                             links_[contact.second].position, hold_);
      const int index = link_contacts_.size() - 1;
      pull = NormalPull(contact.geometry.depth, link_contacts_.Speed(index, 0, velocities_));
    }
  }
}

// The one that pushes the link up `normal`.
void TreeSolver::AddGroundContact(int link, const Vector3& normal, const Contact& contact) {
  const Vector3 arm = ToEigen(contact.geometry.pos) - links_[link].position;
  GroundContact added;
  added.link = link;
  added.row << normal, arm.cross(normal);
  added.pull = NormalPull(contact.geometry.depth, added.row.dot(velocities_[link]));
  ground_contacts_.push_back(added);
  if (contact.friction < kInfinity) return AddGroundFriction(arm, contact.friction);
  links_[link].inertia += PointInertia(arm, hold_);
  links_[link].inertia -= hold_ * added.row * added.row.transpose();
}

void TreeSolver::AddGroundFriction(const Vector3& arm, double coefficient) {
  for (const Vector3& direction : SlidingDirections(ground_contacts_.back().normal())) {
    GroundFriction& friction = ground_frictions_.emplace_back();
    friction.contact = ground_contacts_.size() - 1;
    friction.coefficient = coefficient;
    friction.row << direction, arm.cross(direction);
  }
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
  FindStates();
  if (ground_frictions_.empty() && !link_contacts_.has_frictions()) return;
  LimitFrictions();
  FindStates();
}

void TreeSolver::LimitFrictions() {
  for (GroundFriction& friction : ground_frictions_) {
    const GroundContact& contact = ground_contacts_[friction.contact];
    const double impulse = contact.pull.ImpulseAt(contact.row.dot(velocities_[contact.link]));
    friction.pull = FrictionPull(friction.coefficient, impulse, hold_);
  }
  link_contacts_.LimitFrictions(velocities_);
}

void TreeSolver::FindStates() {
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
  for (const GroundFriction& friction : ground_frictions_) {
    const int link = ground_contacts_[friction.contact].link;
    inertias_[link] += friction.pull.hold() * friction.row * friction.row.transpose();
    momenta_[link] += friction.pull.load() * friction.row;
  }
  link_contacts_.AddLimitedImpulses(momenta_);
  for (size_t b = 0; b < branches_.size(); ++b) tree_.joints()[b].load = loads_[b];
  for (const JointForces& forces : forces_) {
    TreeJoint& joint = tree_.joints()[forces.branch];
    double hold = 0;
    double impulse = forces.impulse;
    for (const LimitedPull& pull : forces.pulls) {
      hold += pull.hold();
      impulse += pull.load();
    }
    joint.hold_of_free = hold + forces.stop.hold();
    geometries_[forces.branch]->AddImpulse(impulse + forces.stop.load(), joint);
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
      impulses[ground_contacts_[ground_contact].link] += ImpulseOf(ground_contact, contact);
      ++ground_contact;
    } else {
      const Vector3 impulse = link_contacts_.Impulse(link_contact++, velocities_);
      impulses[contact.first] += impulse;
      impulses[contact.second] -= impulse;
    }
  }
}

// Along the normal a pull within its limits, across it what keeps the link from sliding.
Vector3 TreeSolver::ImpulseOf(size_t index, const Contact& geometry) const {
  const GroundContact& contact = ground_contacts_[index];
  const Vector6& velocity = velocities_[contact.link];
  const double speed = contact.row.dot(velocity);
  const Vector3 pushed = contact.pull.ImpulseAt(speed) * contact.normal();
  if (geometry.friction < kInfinity) {
    Vector3 held = Vector3::Zero();
    for (const GroundFriction& friction : ground_frictions_) {
      if (friction.contact != index) continue;
      held += friction.pull.ImpulseAt(friction.row.dot(velocity)) * friction.row.head<3>();
    }
    return pushed + held;
  }
  const Vector3 arm = ToEigen(geometry.geometry.pos) - links_[contact.link].position;
  const Vector3 sliding =
      velocity.head<3>() + velocity.tail<3>().cross(arm) - speed * contact.normal();
  return pushed - hold_ * sliding;
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
  for (JointForces& forces : forces_) {
    const double speed = SpeedOf(forces);
    for (LimitedPull& pull : forces.pulls) judge(pull, speed);
    judge(forces.stop, speed);
  }
  for (GroundContact& contact : ground_contacts_) {
    judge(contact.pull, contact.row.dot(velocities_[contact.link]));
  }
  for (GroundFriction& friction : ground_frictions_) {
    const GroundContact& contact = ground_contacts_[friction.contact];
    judge(friction.pull, friction.row.dot(velocities_[contact.link]));
  }
  for (int i = 0; i < link_contacts_.size(); ++i) {
    const std::span<LimitedPull> pulls = link_contacts_.limited_pulls(i);
    for (size_t row = 0; row < pulls.size(); ++row) {
      judge(pulls[row], link_contacts_.Speed(i, row, velocities_));
    }
  }
  if (last != nullptr) last->state = last_state;
  return wrong;
}

}  // namespace runtime
