#include "runtime/training/simulation/collision.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace runtime {
namespace {

double BoundingRadius(const robot::LinkShape& shape) {
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return std::hypot(shape.size[0], shape.size[1], shape.size[2]) / 2;
    case robot::ShapeKind::kCapsule:
      return shape.length / 2;
    case robot::ShapeKind::kCylinder:
      return std::hypot(shape.radius, shape.length / 2);
    case robot::ShapeKind::kSphere:
      break;
  }
  return shape.radius;
}

// Which links do not collide. Links that are welded together count as one.
class Joined {
 public:
  explicit Joined(const robot::RobotDescription& robot) : one_(robot.links.size()) {
    std::iota(one_.begin(), one_.end(), 0);
    for (const robot::Branch& branch : robot.Branches()) {
      const bool is_welded =
          branch.mount >= 0 && robot.mounts[branch.mount].kind == robot::MountKind::kFixed;
      if (is_welded) {
        one_[branch.child] = one_[branch.parent];
      } else {
        pairs_.insert(std::minmax(one_[branch.parent], branch.child));
      }
    }
    for (const auto& [first, second] : robot.contact_exclusions) {
      excluded_.insert(std::minmax(first, second));
    }
  }

  bool operator()(int first, int second) const {
    const int a = one_[first];
    const int b = one_[second];
    return a == b || pairs_.contains(std::minmax(a, b)) ||
           excluded_.contains(std::minmax(first, second));
  }

 private:
  std::vector<int> one_;  // the first of those that each link is welded to
  std::set<std::pair<int, int>> pairs_;
  std::set<std::pair<int, int>> excluded_;
};

}  // namespace

Collision::Collision(const robot::RobotDescription& robot, const RobotBody& body)
    : body_(body),
      plane_(dCreatePlane(nullptr, 0, 0, 1, 0)),
      first_movable_(robot.has_fixed_base ? 1 : 0),
      centers_(robot.links.size()),
      ground_(robot.links.size(), 0) {
  for (const robot::Link& link : robot.links) {
    radii_.push_back(BoundingRadius(link.shape));
    frictions_.push_back(link.friction);
  }
  const Joined are_joined(robot);
  for (int i = 0; i < body.link_count(); ++i) {
    for (int j = i + 1; j < body.link_count(); ++j) {
      if (!are_joined(i, j)) pairs_.push_back({i, j, radii_[i] + radii_[j]});
    }
  }
  contacts_.reserve(kMaxContacts * robot.links.size());
}

void Collision::Update() {
  contacts_.clear();
  FindCenters();
  for (int i = 0; i < body_.link_count(); ++i) {
    const bool near = i >= first_movable_ && centers_[i][2] <= radii_[i];
    ground_[i] = near && AddContacts(Contact::kGround, i) ? 1 : 0;
  }
  for (const Pair& pair : pairs_) {
    if (MayTouch(pair)) AddContacts(pair.first, pair.second);
  }
}

void Collision::FindCenters() {
  for (int i = 0; i < body_.link_count(); ++i) {
    std::copy_n(dGeomGetPosition(body_.geom(i)), 3, centers_[i].begin());
  }
}

bool Collision::MayTouch(const Pair& pair) const {
  const robot::Vector3& a = centers_[pair.first];
  const robot::Vector3& b = centers_[pair.second];
  const double x = a[0] - b[0];
  const double y = a[1] - b[1];
  const double z = a[2] - b[2];
  return x * x + y * y + z * z <= pair.reach * pair.reach;
}

dGeomID Collision::GeomOf(int link) const {
  return link == Contact::kGround ? plane_.get() : body_.geom(link);
}

bool Collision::AddContacts(int first, int second) {
  dContactGeom found[kMaxContacts];
  const double friction = first == Contact::kGround
                              ? frictions_[second]
                              : std::min(frictions_[first], frictions_[second]);
  const int count = dCollide(GeomOf(first), GeomOf(second), kMaxContacts, found, sizeof *found);
  for (int i = 0; i < count; ++i) {
    const bool swapped = found[i].g1 != GeomOf(first);
    contacts_.push_back({swapped ? second : first, swapped ? first : second, found[i], friction});
  }
  return count > 0;
}

}  // namespace runtime
