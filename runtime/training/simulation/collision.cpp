#include "runtime/training/simulation/collision.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "plugins/robot/shape_extent.h"
#include "runtime/training/simulation/convex_ground.h"

namespace runtime {
namespace {

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

std::vector<std::array<int, 2>> CollidingLinks(const robot::RobotDescription& robot) {
  const Joined are_joined(robot);
  const int count = static_cast<int>(robot.links.size());
  std::vector<std::array<int, 2>> pairs;
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) {
      if (!are_joined(i, j)) pairs.push_back({i, j});
    }
  }
  return pairs;
}

Collision::Collision(const robot::RobotDescription& robot, const RobotBody& body,
                     const Surroundings& around)
    : links_(robot.links.size()), first_movable_(robot.has_fixed_base ? 1 : 0) {
  AddSolids(robot, body, around);
  AddPairs(Joined(robot));
  centers_.resize(solids_.size());
  ground_.resize(solids_.size(), 0);
  contacts_.reserve(kMaxContacts * solids_.size());
}

void Collision::AddSolids(const robot::RobotDescription& robot, const RobotBody& body,
                          const Surroundings& around) {
  for (const GroundPart& part : around.ground()) {
    parts_.push_back({&part, {part.geom.get(), Contact::kGround, 0, around.friction()}});
  }
  for (size_t i = 0; i < links_; ++i) {
    const robot::Link& link = robot.links[i];
    const int index = static_cast<int>(i);
    solids_.push_back({body.geom(index), index, robot::RadiusAround(link.shape), link.friction,
                       body.corners(index)});
  }
  const std::span<const world::Thing> things = around.things();
  for (size_t i = 0; i < things.size(); ++i) {
    solids_.push_back({around.GeomOf(i, body), around.BodyOf(i),
                       robot::RadiusAround(things[i].shape), things[i].friction});
  }
  touches_.resize(things.size() * links_, 0);
}

template <class AreJoined>
void Collision::AddPairs(const AreJoined& are_joined) {
  const auto moves = [&](size_t i) {
    return i < links_ ? static_cast<int>(i) >= first_movable_ : solids_[i].body >= 0;
  };
  for (size_t i = 0; i < solids_.size(); ++i) {
    for (size_t j = i + 1; j < solids_.size(); ++j) {
      const bool are_links = j < links_;
      if (are_links ? are_joined(static_cast<int>(i), static_cast<int>(j)) : !moves(i) && !moves(j))
        continue;
      Pair& pair = pairs_.emplace_back();
      pair = {i, j, solids_[i].radius + solids_[j].radius};
      if (i < links_ && !are_links) pair.touch = static_cast<int>((j - links_) * links_ + i);
    }
  }
}

void Collision::Update() {
  contacts_.clear();
  for (size_t i = 0; i < solids_.size(); ++i) {
    std::copy_n(dGeomGetPosition(solids_[i].geom), 3, centers_[i].begin());
  }
  for (size_t i = 0; i < solids_.size(); ++i) {
    const bool moves = solids_[i].body >= (i < links_ ? first_movable_ : 0);
    ground_[i] = moves && TouchesGround(i) ? 1 : 0;
  }
  for (const Pair& pair : pairs_) {
    const bool touch = MayTouch(pair) && AddContacts(solids_[pair.first], solids_[pair.second]);
    if (pair.touch >= 0) touches_[static_cast<size_t>(pair.touch)] = touch ? 1 : 0;
  }
}

bool Collision::TouchesGround(size_t solid) {
  const robot::Vector3& center = centers_[solid];
  const double radius = solids_[solid].radius;
  bool touches = false;
  for (const Part& part : parts_) {
    const GroundPart& ground = *part.ground;
    const bool near = ToEigen(center.data()).dot(ground.normal) - ground.offset <= radius &&
                      center[0] + radius >= ground.low_x && center[0] - radius <= ground.high_x;
    if (near && AddContacts(part.solid, solids_[solid])) touches = true;
  }
  return touches;
}

bool Collision::MayTouch(const Pair& pair) const {
  const robot::Vector3& a = centers_[pair.first];
  const robot::Vector3& b = centers_[pair.second];
  const double x = a[0] - b[0];
  const double y = a[1] - b[1];
  const double z = a[2] - b[2];
  return x * x + y * y + z * z <= pair.reach * pair.reach;
}

int Collision::FindContacts(const Solid& first, const Solid& second,
                            std::span<dContactGeom> found) {
  constexpr size_t kMostCorners = 6;
  if (!second.corners.empty() && dGeomGetClass(first.geom) == dPlaneClass)
    return CornersBelow(first.geom, second.geom, second.corners, found.first(kMostCorners));
  return dCollide(first.geom, second.geom, static_cast<int>(found.size()), found.data(),
                  sizeof found.front());
}

bool Collision::AddContacts(const Solid& first, const Solid& second) {
  dContactGeom found[kMaxContacts];
  const double friction = std::min(first.friction, second.friction);
  const int count = FindContacts(first, second, found);
  for (int i = 0; i < count; ++i) {
    const bool swapped = found[i].g1 != first.geom;
    contacts_.push_back({swapped ? second.body : first.body, swapped ? first.body : second.body,
                         found[i], friction});
  }
  return count > 0;
}

}  // namespace runtime
