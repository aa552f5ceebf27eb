#include "runtime/simulation/collision.h"

#include <algorithm>
#include <cmath>

namespace runtime {
namespace {

double BoundingRadius(const robot::LinkShape& shape) {
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return std::hypot(shape.size[0], shape.size[1], shape.size[2]) / 2;
    case robot::ShapeKind::kCapsule:
      return shape.length / 2;
    case robot::ShapeKind::kSphere:
      break;
  }
  return shape.radius;
}

bool AreJoined(const robot::RobotDescription& robot, int first, int second) {
  return std::any_of(robot.joints.begin(), robot.joints.end(), [&](const robot::Joint& joint) {
    return (joint.parent == first && joint.child == second) ||
           (joint.parent == second && joint.child == first);
  });
}

// The friction is unlimited: what touches does not slide.
dSurfaceParameters Surface(Softness softness) {
  dSurfaceParameters surface{};
  surface.mode = dContactBounce | dContactSoftERP | dContactSoftCFM;
  surface.mu = dInfinity;
  surface.bounce = 1e-5;
  surface.bounce_vel = 0.1;
  surface.soft_erp = softness.erp;
  surface.soft_cfm = softness.cfm;
  return surface;
}

}  // namespace

Collision::Collision(const robot::RobotDescription& robot, const RobotBody& body, dWorldID world,
                     Softness softness)
    : body_(body),
      world_(world),
      plane_(dCreatePlane(nullptr, 0, 0, 1, 0)),
      contacts_(dJointGroupCreate(0)),
      centres_(robot.links.size()),
      ground_(robot.links.size(), 0) {
  const dSurfaceParameters surface = Surface(softness);
  for (dContact& contact : found_) contact.surface = surface;
  for (const robot::Link& link : robot.links) radii_.push_back(BoundingRadius(link.shape));
  for (int i = 0; i < body.link_count(); ++i) {
    for (int j = i + 1; j < body.link_count(); ++j) {
      if (!AreJoined(robot, i, j)) pairs_.push_back({i, j, radii_[i] + radii_[j]});
    }
  }
}

void Collision::Update() {
  RemoveContacts();
  FindCentres();
  for (int i = 0; i < body_.link_count(); ++i) {
    const bool near = centres_[i][2] <= radii_[i];
    ground_[i] = near && AddContacts(plane_.get(), body_.geom(i)) ? 1 : 0;
  }
  for (const Pair& pair : pairs_) {
    if (MayTouch(pair)) AddContacts(body_.geom(pair.first), body_.geom(pair.second));
  }
}

void Collision::FindCentres() {
  for (int i = 0; i < body_.link_count(); ++i) {
    std::copy_n(dBodyGetPosition(body_.body(i)), 3, centres_[i].begin());
  }
}

void Collision::RemoveContacts() {
  dJointGroupEmpty(contacts_.get());
  contact_count_ = 0;
}

bool Collision::MayTouch(const Pair& pair) const {
  const robot::Vector3& a = centres_[pair.first];
  const robot::Vector3& b = centres_[pair.second];
  const double x = a[0] - b[0];
  const double y = a[1] - b[1];
  const double z = a[2] - b[2];
  return x * x + y * y + z * z <= pair.reach * pair.reach;
}

bool Collision::AddContacts(dGeomID first, dGeomID second) {
  const int count = dCollide(first, second, kMaxContacts, &found_[0].geom, sizeof(dContact));
  for (int i = 0; i < count; ++i) {
    const dJointID contact = dJointCreateContact(world_, contacts_.get(), &found_[i]);
    dJointAttach(contact, dGeomGetBody(found_[i].geom.g1), dGeomGetBody(found_[i].geom.g2));
  }
  contact_count_ += count;
  return count > 0;
}

}  // namespace runtime
