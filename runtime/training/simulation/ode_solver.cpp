#include "runtime/training/simulation/ode_solver.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace runtime {
namespace {

// Where the friction is unlimited, what touches does not slide.
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

// As a pyramid: along each of two directions at most this share of the normal's force.
void SetFriction(double friction, dSurfaceParameters& surface) {
  const bool is_limited = friction < robot::kUnlimited;
  surface.mu = friction;
  surface.mode = is_limited ? surface.mode | dContactApprox1 : surface.mode & ~dContactApprox1;
}

}  // namespace

OdeSolver::OdeSolver(const robot::RobotDescription& robot, const SolverSettings& settings,
                     const JointController& controller, const RobotBody& body, dWorldID world)
    : body_(body),
      world_(world),
      time_step_(settings.time_step),
      joints_(robot.joints),
      turns_(robot.joints.size(), 0.0),
      pulls_(robot.joints.size()),
      contacts_(dJointGroupCreate(0)),
      contact_{} {
  contact_.surface = Surface(settings);
  for (int j = 0; j < body.joint_count(); ++j) {
    for (size_t i = 0; i < controller.pulls(j).size(); ++i) {
      pulls_[j].push_back(body.joint(j).MakePull(world));
    }
  }
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
    BodyJoint& joint = body_.joint(j);
    if (!controller.has_motors()) joint.AddTorque(controller.torques()[j]);
    const std::span<const Motor> motors = controller.pulls(j);
    for (size_t i = 0; i < motors.size(); ++i) joint.SetPull(pulls_[j][i].get(), motors[i]);
  }
}

// ODE measures angles from -pi to pi. Where a joint has gone on beyond that, ODE has to see the
// stops where it sees the joint, or it would throw the joint all the way around.
void OdeSolver::MoveStops(const JointController& controller) {
  constexpr double kTurn = 2 * std::numbers::pi;
  for (int j = 0; j < body_.joint_count(); ++j) {
    if (!body_.joint(j).Turns() || !joints_[j].HasStops()) continue;
    const double turn = -kTurn * std::nearbyint(controller.angles()[j] / kTurn);
    if (turn == turns_[j]) continue;
    body_.joint(j).SetStops(joints_[j].low + turn, joints_[j].high + turn);
    turns_[j] = turn;
  }
}

void OdeSolver::MakeContacts(std::span<const Contact> contacts, bool has_feedback) {
  dJointGroupEmpty(contacts_.get());
  if (has_feedback) feedback_.assign(contacts.size(), {});
  for (size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    contact_.geom = contact.geometry;
    SetFriction(contact.friction, contact_.surface);
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
