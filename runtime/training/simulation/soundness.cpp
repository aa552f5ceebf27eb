#include "runtime/training/simulation/soundness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace runtime {

Soundness::Soundness(const robot::RobotDescription& robot, const RobotBody& body, double gravity,
                     double time_step)
    : robot_(robot), body_(body), gravity_(gravity), rates_(robot.joints.size(), 0.0) {
  for (const robot::Joint& joint : robot.joints) {
    largest_impulses_.push_back(time_step * robot.GainsOf(joint).max_torque);
  }
  double total = 0;
  for (int i = 0; i < body.body_count(); ++i) {
    masses_.push_back(InertiaOf(body.body(i)));
    if (i < body.link_count()) total += masses_.back().mass;
  }
  limit_ = kMostLift * gravity * total;
}

void Soundness::Check(const JointController& controller) {
  const double energy = Energy(controller);
  const double work = MostWork(controller);
  if (!is_first_) from_nothing_ += std::max(0.0, energy - energy_ - work);
  is_first_ = false;
  energy_ = energy;
  if (!(from_nothing_ < limit_)) throw OdeFailure("energy appears from nothing");
  CheckStops(controller);
}

double Soundness::Energy(const JointController& controller) const {
  double energy = 0;
  for (int i = 0; i < body_.body_count(); ++i) {
    const dBodyID body = body_.body(i);
    const LinkInertia& link = masses_[i];
    const dReal* v = dBodyGetLinearVel(body);
    const dReal* w = dBodyGetAngularVel(body);
    const Matrix3 axes = link.AxesIn(RotationOf(body));
    energy += link.mass * (gravity_ * dBodyGetPosition(body)[2] +
                           0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    for (int axis = 0; axis < 3; ++axis) {
      const double rate = axes(0, axis) * w[0] + axes(1, axis) * w[1] + axes(2, axis) * w[2];
      energy += 0.5 * link.principal[axis] * rate * rate;
    }
  }
  for (size_t j = 0; j < robot_.joints.size(); ++j) {
    energy += EnergyOf(robot_.joints[j].passive, controller.angles()[j], controller.rates()[j]);
  }
  return energy;
}

double Soundness::EnergyOf(const robot::PassiveForces& forces, double angle, double rate) const {
  const double strain = angle - forces.spring_rest;
  return 0.5 * (forces.spring * strain * strain + forces.armature * rate * rate);
}

double Soundness::MostWork(const JointController& controller) {
  double work = 0;
  for (size_t j = 0; j < rates_.size(); ++j) {
    const double rate = std::abs(controller.rates()[j]);
    work += largest_impulses_[j] * std::max(rate, rates_[j]);
    rates_[j] = rate;
  }
  return work;
}

void Soundness::CheckStops(const JointController& controller) const {
  for (size_t j = 0; j < robot_.joints.size(); ++j) {
    const robot::Joint& joint = robot_.joints[j];
    const double angle = controller.angles()[j];
    if (angle < joint.low - kFarthestPastStop || angle > joint.high + kFarthestPastStop)
      throw OdeFailure(fmt::format("the joint {} is far beyond its stop", joint.name));
  }
}

}  // namespace runtime
