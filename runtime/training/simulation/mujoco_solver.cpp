#include "runtime/training/simulation/mujoco_solver.h"

#include <algorithm>
#include <vector>

#include "runtime/base/user_error.h"
#include "runtime/training/simulation/limit.h"
#include "runtime/training/simulation/link_motion.h"
#include "runtime/training/simulation/mujoco_model.h"

namespace runtime {
namespace {

// The bodies are the state, as with the other solvers: MuJoCo's is made of theirs before each step,
// and moves them after it. Only what it begins its search for forces from goes from step to step.
//
// A motor that is stepped implicitly is an inertia beside a torque: where the impulse of a pull is
// load - hold * v with the speed v at the end of the step, the joint is as if  hold  belonged to
// its inertia, and  load - hold * v  with the speed before were applied. So MuJoCo's contacts see
// the motors as they are; its own implicit integrators know nothing of them when they solve for
// the contacts.
class MujocoSolver : public PhysicsSolver {
 public:
  MujocoSolver(const robot::RobotDescription& robot, const SolverSettings& settings,
               const JointController& controller, RobotBody& body);

  void Step(std::span<const Contact> contacts, const JointController& controller,
            std::span<Vector3> impulses) override;
  std::span<const unsigned char> ground() const override { return ground_; }

 private:
  struct Joint {
    int position;  // in qpos
    int speed;     // in qvel
    double radius;
    size_t pull_count;  // of the controller's; the rest, dry friction, is MuJoCo's
    std::vector<LimitedPull> pulls;
  };
  struct Ball {
    int parent;
    int child;
    int position;
    int speed;
    double hold;
  };

  int IdOf(mjtObj kind, const std::string& name) const {
    return mj_name2id(model_.get(), kind, name.c_str());
  }
  void ReadBase();
  void ReadBall(const Ball& ball);
  void ReadJoints(const JointController& controller);
  void SolveForAccelerations();
  void ApplyPulls();
  bool CorrectStates();
  void ReadGround();
  void AddImpulses(std::span<Vector3> impulses) const;
  void MoveBodies();

  double time_step_;
  RobotBody& body_;
  bool has_fixed_base_;
  std::shared_ptr<const mjModel> model_;
  MujocoData data_;
  std::vector<int> bodies_;  // MuJoCo's of each link
  std::vector<int> links_;   // the link of each of MuJoCo's bodies; of its world none
  std::vector<Joint> joints_;
  std::vector<Ball> balls_;
  std::vector<double> inertias_;  // the matrix of them without any pull
  std::vector<unsigned char> ground_;
};

MujocoSolver::MujocoSolver(const robot::RobotDescription& robot, const SolverSettings& settings,
                           const JointController& controller, RobotBody& body)
    : time_step_(settings.time_step),
      body_(body),
      has_fixed_base_(robot.has_fixed_base),
      model_(CompiledModel(Mjcf(robot, settings, body))),
      data_(mj_makeData(model_.get())),
      links_(model_->nbody, Contact::kGround),
      inertias_(model_->nM),
      ground_(robot.links.size(), 0) {
  for (const robot::Link& link : robot.links) {
    bodies_.push_back(IdOf(mjOBJ_BODY, link.name));
    links_[bodies_.back()] = static_cast<int>(bodies_.size()) - 1;
  }
  for (size_t j = 0; j < robot.joints.size(); ++j) {
    const robot::Joint& joint = robot.joints[j];
    const int id = IdOf(mjOBJ_JOINT, joint.name);
    const size_t pulls =
        controller.pulls(static_cast<int>(j)).size() - (joint.passive.friction > 0 ? 1 : 0);
    joints_.push_back({model_->jnt_qposadr[id], model_->jnt_dofadr[id], joint.radius, pulls,
                       std::vector<LimitedPull>(pulls)});
  }
  for (const robot::Mount& mount : robot.mounts) {
    if (mount.kind != robot::MountKind::kBall) continue;
    const int id = IdOf(mjOBJ_JOINT, mount.name);
    balls_.push_back({mount.parent, mount.child, model_->jnt_qposadr[id], model_->jnt_dofadr[id],
                      time_step_ * mount.damper});
  }
}

void MujocoSolver::Step(std::span<const Contact>, const JointController& controller,
                        std::span<Vector3> impulses) {
  const mjModel* model = model_.get();
  mjData* data = data_.get();
  ReadBase();
  for (const Ball& ball : balls_) ReadBall(ball);
  ReadJoints(controller);
  try {
    mj_kinematics(model, data);
    mj_comPos(model, data);
    mj_crb(model, data);
    mj_collision(model, data);
    mj_makeConstraint(model, data);
    mj_fwdVelocity(model, data);
    SolveForAccelerations();
    ReadGround();
    if (!impulses.empty()) AddImpulses(impulses);
    mj_Euler(model, data);
    mj_kinematics(model, data);
    mj_comPos(model, data);
    mj_comVel(model, data);
  } catch (const UserError& error) {
    throw OdeFailure(error.what());
  }
  if (data->warning[mjWARN_CONTACTFULL].number > 0 || data->warning[mjWARN_CNSTRFULL].number > 0) {
    throw OdeFailure("there are more contacts than MuJoCo has memory for");
  }
  MoveBodies();
}

void MujocoSolver::ReadBase() {
  const dBodyID base = body_.body(0);
  mjtNum* position = has_fixed_base_ ? data_->mocap_pos : data_->qpos;
  mjtNum* orientation = has_fixed_base_ ? data_->mocap_quat : data_->qpos + 3;
  std::copy_n(dBodyGetPosition(base), 3, position);
  std::copy_n(dBodyGetQuaternion(base), 4, orientation);
  if (has_fixed_base_) return;
  // A free joint's turning is told in the frame of its body.
  std::copy_n(dBodyGetLinearVel(base), 3, data_->qvel);
  const Vector3 turning = ToEigen(dBodyGetAngularVel(base));
  Vector3::Map(data_->qvel + 3) = RotationOf(base).transpose() * turning;
}

void MujocoSolver::ReadBall(const Ball& ball) {
  const dBodyID parent = body_.body(ball.parent);
  const dBodyID child = body_.body(ball.child);
  dQuaternion between;
  dQMultiply1(between, dBodyGetQuaternion(parent), dBodyGetQuaternion(child));
  std::copy_n(between, 4, data_->qpos + ball.position);
  const Vector3 turning = ToEigen(dBodyGetAngularVel(child)) - ToEigen(dBodyGetAngularVel(parent));
  Vector3::Map(data_->qvel + ball.speed) = RotationOf(child).transpose() * turning;
}

void MujocoSolver::ReadJoints(const JointController& controller) {
  const double h = time_step_;
  for (size_t j = 0; j < joints_.size(); ++j) {
    Joint& joint = joints_[j];
    const double radius = joint.radius;
    data_->qpos[joint.position] = controller.angles()[j] * radius;
    data_->qvel[joint.speed] = controller.rates()[j] * radius;
    const std::span<const Motor> motors = controller.pulls(static_cast<int>(j));
    for (size_t i = 0; i < joint.pulls.size(); ++i) {
      LimitedPull& pull = joint.pulls[i];
      pull.target = motors[i].speed * radius;
      pull.stiffness = h * motors[i].damping / (radius * radius);
      pull.low = -h * motors[i].max_torque / radius;
      pull.high = h * motors[i].max_torque / radius;
    }
  }
}

// Until all pulls are within their limits, or at those that they are assumed to be at.
void MujocoSolver::SolveForAccelerations() {
  constexpr int kMostRounds = 5;  // after which a torque may be a little beyond its limit
  std::copy_n(data_->qM, model_->nM, inertias_.begin());
  for (int round = 0; round < kMostRounds; ++round) {
    ApplyPulls();
    mj_factorM(model_.get(), data_.get());
    mj_fwdAcceleration(model_.get(), data_.get());
    mj_fwdConstraint(model_.get(), data_.get());
    std::copy_n(data_->qacc, model_->nv, data_->qacc_warmstart);
    if (CorrectStates()) return;
  }
}

void MujocoSolver::ApplyPulls() {
  std::copy_n(inertias_.begin(), model_->nM, data_->qM);
  const auto apply = [&](int dof, double hold, double load) {
    data_->qM[model_->dof_Madr[dof]] += hold - model_->dof_armature[dof];
    data_->qfrc_applied[dof] = (load - hold * data_->qvel[dof]) / time_step_;
  };
  for (const Joint& joint : joints_) {
    double hold = 0;
    double load = 0;
    for (const LimitedPull& pull : joint.pulls) {
      hold += pull.hold();
      load += pull.load();
    }
    apply(joint.speed, hold, load);
  }
  for (const Ball& ball : balls_) {
    for (int axis = 0; axis < 3; ++axis) apply(ball.speed + axis, ball.hold, 0);
  }
}

// Returns whether all states were right.
bool MujocoSolver::CorrectStates() {
  bool right = true;
  for (Joint& joint : joints_) {
    const double speed = data_->qvel[joint.speed] + time_step_ * data_->qacc[joint.speed];
    for (LimitedPull& pull : joint.pulls) {
      const LimitedPull::State next = pull.NextState(speed);
      right = right && next == pull.state;
      pull.state = next;
    }
  }
  return right;
}

void MujocoSolver::ReadGround() {
  std::ranges::fill(ground_, 0);
  for (int i = 0; i < data_->ncon; ++i) {
    const int first = links_[model_->geom_bodyid[data_->contact[i].geom1]];
    const int second = links_[model_->geom_bodyid[data_->contact[i].geom2]];
    if (first == Contact::kGround) ground_[second] = 1;
    if (second == Contact::kGround) ground_[first] = 1;
  }
}

// A contact's force is told in its own frame, and acts on the second of the two shapes.
void MujocoSolver::AddImpulses(std::span<Vector3> impulses) const {
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& contact = data_->contact[i];
    mjtNum force[6];
    mj_contactForce(model_.get(), data_.get(), i, force);
    const Vector3 impulse = time_step_ * Matrix3::Map(contact.frame).transpose() * ToEigen(force);
    const int first = links_[model_->geom_bodyid[contact.geom1]];
    const int second = links_[model_->geom_bodyid[contact.geom2]];
    if (first != Contact::kGround) impulses[first] -= impulse;
    if (second != Contact::kGround) impulses[second] += impulse;
  }
}

void MujocoSolver::MoveBodies() {
  for (int link = has_fixed_base_ ? 1 : 0; link < body_.link_count(); ++link) {
    const int id = bodies_[link];
    const dBodyID body = body_.body(link);
    const mjtNum* position = data_->xpos + 3 * id;
    const mjtNum* orientation = data_->xquat + 4 * id;
    dBodySetPosition(body, position[0], position[1], position[2]);
    const dQuaternion turned = {orientation[0], orientation[1], orientation[2], orientation[3]};
    dBodySetQuaternion(body, turned);
    mjtNum velocity[6];  // the turning first
    mj_objectVelocity(model_.get(), data_.get(), mjOBJ_XBODY, id, velocity, 0);
    dBodySetAngularVel(body, velocity[0], velocity[1], velocity[2]);
    dBodySetLinearVel(body, velocity[3], velocity[4], velocity[5]);
  }
}

}  // namespace

bool HasMujoco() { return true; }

std::unique_ptr<PhysicsSolver> MakeMujocoSolver(const robot::RobotDescription& robot,
                                                const SolverSettings& settings,
                                                const JointController& controller,
                                                RobotBody& body) {
  return std::make_unique<MujocoSolver>(robot, settings, controller, body);
}

}  // namespace runtime
