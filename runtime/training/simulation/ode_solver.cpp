#include "runtime/training/simulation/ode_solver.h"

#include <numbers>
#include <utility>

namespace runtime {
namespace {

// The friction is unlimited: what touches does not slide.
dSurfaceParameters Surface(const SolverSettings& settings) {
  dSurfaceParameters surface{};
  surface.mode = dContactBounce | dContactSoftERP | dContactSoftCFM;
  surface.mu = dInfinity;
  surface.bounce = settings.bounce;
  surface.bounce_vel = settings.bounce_speed;
  surface.soft_erp = settings.contacts.erp;
  surface.soft_cfm = settings.contacts.cfm;
  return surface;
}

}  // namespace

OdeSolver::OdeSolver(const robot::RobotDescription& robot, const Profile& profile,
                     const SolverSettings& settings, const RobotBody& body, dWorldID world)
    : body_(body),
      world_(world),
      time_step_(settings.time_step),
      drive_(profile.drive),
      joints_(robot.joints),
      turns_(robot.joints.size(), 0.0),
      contacts_(dJointGroupCreate(0)),
      contact_{} {
  contact_.surface = Surface(settings);
  if (drive_ != JointDrive::kMotor) return;
  for (const robot::Joint& joint : robot.joints) AddMotor(joint);
}

// A joint of its own beside the hinge: a hinge's built-in motor pushes with all its force at a
// stop.
void OdeSolver::AddMotor(const robot::Joint& joint) {
  OdeJoint motor(dJointCreateAMotor(world_, nullptr));
  const dBodyID parent = body_.body(joint.parent);
  dJointAttach(motor.get(), parent, body_.body(joint.child));
  dJointSetAMotorNumAxes(motor.get(), 1);
  dVector3 axis;
  dBodyVectorToWorld(parent, joint.axis[0], joint.axis[1], joint.axis[2], axis);
  constexpr int kMovesWithParent = 1;
  dJointSetAMotorAxis(motor.get(), 0, kMovesWithParent, axis[0], axis[1], axis[2]);
  motors_.push_back(std::move(motor));
}

void OdeSolver::Step(std::span<const Contact> contacts, const JointController& controller,
                     std::span<Vector3> impulses) {
  Drive(controller);
  MoveStops(controller);
  MakeContacts(contacts, !impulses.empty());
  dWorldStep(world_, time_step_);
  if (!impulses.empty()) AddImpulses(contacts, impulses);
}

void OdeSolver::Drive(const JointController& controller) {
  for (int j = 0; j < body_.joint_count(); ++j) {
    if (drive_ == JointDrive::kTorque) {
      dJointAddHingeTorque(body_.hinge(j), controller.torques()[j]);
    } else {
      const Motor& motor = controller.motors()[j];
      dJointSetAMotorParam(motors_[j].get(), dParamFMax, motor.max_torque);
      dJointSetAMotorParam(motors_[j].get(), dParamCFM, 1 / motor.damping);
      dJointSetAMotorParam(motors_[j].get(), dParamVel, motor.speed);
    }
  }
}

// ODE measures angles from -pi to pi. Where a joint has given way beyond that, ODE has to see the
// stops where it sees the joint, or it would throw the joint all the way around.
void OdeSolver::MoveStops(const JointController& controller) {
  using std::numbers::pi;
  for (int j = 0; j < body_.joint_count(); ++j) {
    const double angle = controller.angles()[j];
    const double turn = angle > pi ? -2 * pi : angle < -pi ? 2 * pi : 0;
    if (turn == turns_[j]) continue;
    dJointSetHingeParam(body_.hinge(j), dParamLoStop, joints_[j].low + turn);
    dJointSetHingeParam(body_.hinge(j), dParamHiStop, joints_[j].high + turn);
    turns_[j] = turn;
  }
}

void OdeSolver::MakeContacts(std::span<const Contact> contacts, bool has_feedback) {
  dJointGroupEmpty(contacts_.get());
  if (has_feedback) feedback_.assign(contacts.size(), {});
  for (size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    contact_.geom = contact.geometry;
    const dJointID joint = dJointCreateContact(world_, contacts_.get(), &contact_);
    dJointAttach(joint, BodyOf(contact.first), BodyOf(contact.second));
    if (has_feedback) dJointSetFeedback(joint, &feedback_[i]);
  }
}

// ODE tells the force on the first body that there is, and that on the second.
void OdeSolver::AddImpulses(std::span<const Contact> contacts, std::span<Vector3> impulses) const {
  for (size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    const bool has_first = contact.first != Contact::kGround;
    impulses[has_first ? contact.first : contact.second] += time_step_ * ToEigen(feedback_[i].f1);
    const bool has_both = has_first && contact.second != Contact::kGround;
    if (has_both) impulses[contact.second] += time_step_ * ToEigen(feedback_[i].f2);
  }
}

dBodyID OdeSolver::BodyOf(int link) const {
  return link == Contact::kGround ? nullptr : body_.body(link);
}

}  // namespace runtime
