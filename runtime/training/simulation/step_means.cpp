#include "runtime/training/simulation/step_means.h"

namespace runtime {

StepMeans::StepMeans(const RobotBody& body) : body_(body) {}

void StepMeans::Start(const Wanted& wanted) {
  elapsed_ = 0;
  base_velocity_.resize(wanted.base_acceleration ? 1 : 0);
  joint_velocities_.resize(wanted.joint_accelerations ? body_.joint_count() : 0);
  impulses_.assign(wanted.contact_forces ? body_.body_count() : 0, Vector3::Zero());
  site_velocities_.resize(wanted.site_accelerations ? body_.sites().size() : 0);
  for (Vector3& velocity : base_velocity_) velocity = ToEigen(dBodyGetLinearVel(body_.body(0)));
  for (size_t j = 0; j < joint_velocities_.size(); ++j) {
    joint_velocities_[j] = body_.joint(static_cast<int>(j)).Rate();
  }
  for (size_t i = 0; i < site_velocities_.size(); ++i) {
    site_velocities_[i] = body_.sites()[i].Velocity();
  }
}

Vector3 StepMeans::BaseAcceleration() const {
  if (base_velocity_.empty() || elapsed_ == 0) return Vector3::Zero();
  return (ToEigen(dBodyGetLinearVel(body_.body(0))) - base_velocity_[0]) / elapsed_;
}

double StepMeans::JointAcceleration(int joint) const {
  if (joint_velocities_.empty() || elapsed_ == 0) return 0;
  return (body_.joint(joint).Rate() - joint_velocities_[joint]) / elapsed_;
}

Vector3 StepMeans::ContactForce(int link) const {
  if (impulses_.empty() || elapsed_ == 0) return Vector3::Zero();
  return impulses_[link] / elapsed_;
}

Vector3 StepMeans::SiteAcceleration(int site) const {
  if (site_velocities_.empty() || elapsed_ == 0) return Vector3::Zero();
  return (body_.sites()[site].Velocity() - site_velocities_[site]) / elapsed_;
}

}  // namespace runtime
