#include "runtime/training/simulation/mujoco_solver.h"

#include <algorithm>
#include <vector>

#include "runtime/base/user_error.h"
#include "runtime/training/simulation/limit.h"
#include "runtime/training/simulation/link_motion.h"
#include "runtime/training/simulation/mjcf_surroundings.h"
#include "runtime/training/simulation/mujoco_contacts.h"
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
  MujocoSolver(const robot::RobotDescription& robot, const Surroundings& around,
               const SolverSettings& settings, const JointController& controller, RobotBody& body);

  void Step(std::span<const Contact> contacts, const JointController& controller,
            std::span<Vector3> impulses) override;
  std::span<const unsigned char> ground() const override { return contacts_.ground(); }
  std::span<const unsigned char> touches(size_t thing) const override {
    return contacts_.touches(thing);
  }

 private:
  struct Joint {
    int position;  // in qpos
    int speed;     // in qvel
    double radius;
    size_t pull_count;  // of the controller's; the rest, dry friction, is MuJoCo's
    std::vector<LimitedPull> pulls;
  };
  // A body that nothing holds: the base, or a thing.
  struct Free {
    int body;      // of the robot's, then the things'
    int position;  // in qpos
    int speed;     // in qvel
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
  void AddBody(const std::string& name);
  void AddThings(const Surroundings& around);
  void ReadFixedBase();
  void ReadFree(const Free& free);
  void ReadBall(const Ball& ball);
  void ReadJoints(const JointController& controller);
  void SolveForAccelerations();
  void ApplyPulls();
  bool CorrectStates();
  void MoveBodies();

  double time_step_;
  RobotBody& body_;
  bool has_fixed_base_;
  std::shared_ptr<const mjModel> model_;
  MujocoData data_;
  std::vector<int> bodies_;  // MuJoCo's of each link and thing that moves
  std::vector<Free> frees_;
  std::vector<Joint> joints_;
  std::vector<Ball> balls_;
  std::vector<double> inertias_;  // the matrix of them without any pull
  MujocoContacts contacts_;
};

MujocoSolver::MujocoSolver(const robot::RobotDescription& robot, const Surroundings& around,
                           const SolverSettings& settings, const JointController& controller,
                           RobotBody& body)
    : time_step_(settings.time_step),
      body_(body),
      has_fixed_base_(robot.has_fixed_base),
      model_(CompiledModel(MjcfOf(robot, around, settings, body))),
      data_(mj_makeData(model_.get())),
      inertias_(model_->nM),
      contacts_(*model_, robot.links.size(), around.things().size()) {
  for (const robot::Link& link : robot.links) AddBody(link.name);
  if (!has_fixed_base_) frees_.push_back({0, 0, 0});
  AddThings(around);
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

void MujocoSolver::AddBody(const std::string& name) {
  bodies_.push_back(IdOf(mjOBJ_BODY, name));
  contacts_.SetOwner(bodies_.back(), static_cast<int>(bodies_.size()) - 1);
}

void MujocoSolver::AddThings(const Surroundings& around) {
  for (size_t i = 0; i < around.things().size(); ++i) {
    const std::string name = MjcfNameOf(around.things()[i]);
    contacts_.SetThing(IdOf(mjOBJ_GEOM, name), i);
    if (around.BodyOf(i) < 0) continue;
    AddBody(name);
    const int joint = IdOf(mjOBJ_JOINT, name);
    frees_.push_back({around.BodyOf(i), model_->jnt_qposadr[joint], model_->jnt_dofadr[joint]});
  }
}

void MujocoSolver::Step(std::span<const Contact>, const JointController& controller,
                        std::span<Vector3> impulses) {
  const mjModel* model = model_.get();
  mjData* data = data_.get();
  if (has_fixed_base_) ReadFixedBase();
  for (const Free& free : frees_) ReadFree(free);
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
    contacts_.Read(*data);
    if (!impulses.empty()) contacts_.AddImpulses(*data, time_step_, impulses);
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

void MujocoSolver::ReadFixedBase() {
  std::copy_n(dBodyGetPosition(body_.body(0)), 3, data_->mocap_pos);
  std::copy_n(dBodyGetQuaternion(body_.body(0)), 4, data_->mocap_quat);
}

void MujocoSolver::ReadFree(const Free& free) {
  const dBodyID body = body_.body(free.body);
  std::copy_n(dBodyGetPosition(body), 3, data_->qpos + free.position);
  std::copy_n(dBodyGetQuaternion(body), 4, data_->qpos + free.position + 3);
  std::copy_n(dBodyGetLinearVel(body), 3, data_->qvel + free.speed);
  // A free joint's turning is told in the frame of its body.
  const Vector3 turning = ToEigen(dBodyGetAngularVel(body));
  Vector3::Map(data_->qvel + free.speed + 3) = RotationOf(body).transpose() * turning;
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

void MujocoSolver::MoveBodies() {
  for (int i = has_fixed_base_ ? 1 : 0; i < body_.body_count(); ++i) {
    const int id = bodies_[i];
    const dBodyID body = body_.body(i);
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
                                                const Surroundings& around,
                                                const SolverSettings& settings,
                                                const JointController& controller,
                                                RobotBody& body) {
  return std::make_unique<MujocoSolver>(robot, around, settings, controller, body);
}

}  // namespace runtime
