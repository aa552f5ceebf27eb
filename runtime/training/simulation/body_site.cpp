#include "runtime/training/simulation/body_site.h"

namespace runtime {
namespace {

Eigen::Quaterniond ToQuaternion(const double* q) { return {q[0], q[1], q[2], q[3]}; }

}  // namespace

// In the zero pose the link's frame is parallel to the world's.
BodySite::BodySite(const robot::RobotDescription& robot, const robot::Site& site, dBodyID link)
    : link_(link),
      arm_(ToEigen(robot.ArmOf(site).data())),
      orientation_(ToQuaternion(site.orientation.data())) {}

Vector3 BodySite::Arm() const {
  dVector3 arm;
  dBodyVectorToWorld(link_, arm_[0], arm_[1], arm_[2], arm);
  return ToEigen(arm);
}

Vector3 BodySite::Position() const { return ToEigen(dBodyGetPosition(link_)) + Arm(); }

Eigen::Quaterniond BodySite::Orientation() const {
  return ToQuaternion(dBodyGetQuaternion(link_)) * orientation_;
}

Vector3 BodySite::Velocity() const {
  return ToEigen(dBodyGetLinearVel(link_)) + AngularVelocity().cross(Arm());
}

Vector3 BodySite::AngularVelocity() const { return ToEigen(dBodyGetAngularVel(link_)); }

}  // namespace runtime
