#include "runtime/training/simulation/soundness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace runtime {

Soundness::Soundness(const robot::RobotDescription& robot, const RobotBody& body, double gravity,
                     double time_step)
    : robot_(robot),
      body_(body),
      gravity_(gravity),
      largest_impulse_(time_step * robot.controller.max_torque),
      rates_(robot.joints.size(), 0.0) {
  double total = 0;
  for (int i = 0; i < body.link_count(); ++i) {
    dMass mass;
    dBodyGetMass(body.body(i), &mass);
    masses_.push_back({mass.mass, {mass.I[0], mass.I[5], mass.I[10]}});
    total += mass.mass;
  }
  limit_ = kMostLift * gravity * total;
}

void Soundness::Check(const JointController& controller) {
  const double energy = Energy();
  const double work = MostWork(controller);
  if (!is_first_) from_nothing_ += std::max(0.0, energy - energy_ - work);
  is_first_ = false;
  energy_ = energy;
  if (!(from_nothing_ < limit_)) throw OdeFailure("energy appears from nothing");
  CheckStops(controller);
}

double Soundness::Energy() const {
  double energy = 0;
  for (int i = 0; i < body_.link_count(); ++i) {
    const dBodyID body = body_.body(i);
    const LinkMass& link = masses_[i];
    const dReal* v = dBodyGetLinearVel(body);
    const dReal* w = dBodyGetAngularVel(body);
    const dReal* axes = dBodyGetRotation(body);  // rows of four; the columns are the link's axes
    energy += link.mass * (gravity_ * dBodyGetPosition(body)[2] +
                           0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    for (int axis = 0; axis < 3; ++axis) {
      const double rate = axes[axis] * w[0] + axes[4 + axis] * w[1] + axes[8 + axis] * w[2];
      energy += 0.5 * link.inertia[axis] * rate * rate;
    }
  }
  return energy;
}

double Soundness::MostWork(const JointController& controller) {
  double work = 0;
  for (size_t j = 0; j < rates_.size(); ++j) {
    const double rate = std::abs(controller.rates()[j]);
    work += largest_impulse_ * std::max(rate, rates_[j]);
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
