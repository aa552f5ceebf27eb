// A square with walls in which a point moves; a wind blows it outward.
#include <algorithm>
#include <array>

#include "runtime/core/module/module_library.h"
#include "runtime/training/environment/stepped_environment.h"

namespace {

using Eigen::Vector2d;

struct Wall {
  Vector2d from, to;
};

// Twice the area of the triangle; its sign says on which side of `from` to `to` the point lies.
double Side(const Vector2d& from, const Vector2d& to, const Vector2d& point) {
  const Vector2d way = to - from;
  const Vector2d there = point - from;
  return way.x() * there.y() - way.y() * there.x();
}

bool Crosses(const Wall& wall, const Vector2d& from, const Vector2d& to) {
  return Side(wall.from, wall.to, from) * Side(wall.from, wall.to, to) <= 0 &&
         Side(from, to, wall.from) * Side(from, to, wall.to) <= 0 && from != to;
}

class PlaneMaze : public runtime::SteppedEnvironment {
 public:
  // An action is how far the point pushes itself in a time step [m].
  PlaneMaze(std::string name, const runtime::Context& context)
      : SteppedEnvironment(std::move(name), context, 0.01,
                           {Vector2d(-kFarthest, -kFarthest), Vector2d(kFarthest, kFarthest)}),
        walls_{{{{-0.7, 1.0}, {-0.7, 0.25}},
                {{-0.8, 0.0}, {-0.4, 0.0}},
                {{-0.4, 0.0}, {-0.4, 0.5}},
                {{-0.5, -0.5}, {-0.1, -0.15}},
                {{-0.1, -0.15}, {-0.1, 0.5}},
                {{-0.1, 0.5}, {0.1, 0.5}},
                {{0.1, 0.5}, {0.1, -1.0}},
                {{0.4, 0.5}, {0.4, -0.3}},
                {{0.4, -0.3}, {0.6, 0.2}},
                {{0.6, 0.2}, {0.6, 1.0}}}} {
    AddSensor("position", "vec2", "m", position_.data());
    AddSensor("push", "vec2", "m", push_.data());
  }

 private:
  static constexpr double kFarthest = 0.03;  // [m] in a time step

  void Begin(uint64_t) override {
    position_ = {-0.8, 0.1};
    push_.setZero();
  }

  void Step(const Eigen::VectorXd& action) override {
    push_ = action;
    push_ *= std::min(1.0, kFarthest / std::max(push_.norm(), 1e-12));
    position_ += AlongWalls(push_ + Wind());
  }

  // From half of the way to the border on, and stronger from where the circle around it begins.
  Vector2d Wind() const {
    const double distance = position_.norm();
    if (distance < 0.5) return Vector2d::Zero();
    return position_ / distance * (distance < 1 ? 0.01 : 0.08);
  }

  // A way that a wall bars goes along it, one that two walls bar nowhere.
  Vector2d AlongWalls(Vector2d way) const {
    const Wall* wall = FindBarrier(way);
    if (wall == nullptr) return way;
    const Vector2d along = (wall->to - wall->from).normalized();
    way = way.dot(along) * along;
    return FindBarrier(way) == nullptr ? way : Vector2d::Zero();
  }

  const Wall* FindBarrier(const Vector2d& way) const {
    const auto* found = std::find_if(walls_.begin(), walls_.end(), [&](const Wall& wall) {
      return Crosses(wall, position_, position_ + way);
    });
    return found == walls_.end() ? nullptr : found;
  }

  const std::array<Wall, 10> walls_;
  Vector2d position_ = Vector2d::Zero();
  Vector2d push_ = Vector2d::Zero();
};

}  // namespace

TASKC_MODULES(types) { types.Add<PlaneMaze>("PlaneMaze"); }
