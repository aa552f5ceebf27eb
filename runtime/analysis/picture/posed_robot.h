// A robot at one moment, as rays see it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/behavior/motion.h"
#include "runtime/analysis/picture/shapes.h"

namespace runtime {

struct RobotHit {
  size_t link = 0;
  Hit hit;                // in the world frame
  Eigen::Vector3d place;  // in the frame of the link's shape
};

class PosedRobot {
 public:
  // `links`, which must outlive this: those of the motion, with their shapes.
  PosedRobot(const std::vector<robot::Link>& links, const Motion& motion, int frame);

  // Sets `near` to the links that may come closer to the ray than `width` at its origin, and
  // `widening` more with each meter.
  void FindNear(const Ray& ray, double width, double widening, std::vector<size_t>& near) const;

  // The first of `links` that the ray meets.
  std::optional<RobotHit> FirstHitOf(const std::vector<size_t>& links, const Ray& ray) const;
  // Whether the ray meets any of `links` except `except`.
  bool IsBlocked(const std::vector<size_t>& links, const Ray& ray, size_t except) const;

  // How much of the sky above a surface at `place` the links leave free: 1 is all of it. A link's
  // own surface is not hidden by the link: `except`.
  double Openness(const Eigen::Vector3d& place, const Eigen::Vector3d& normal, size_t except) const;

  static constexpr size_t kNone = static_cast<size_t>(-1);  // no link to except

 private:
  // A ball that holds a link, or all of them.
  struct Bounds {
    Eigen::Vector3d center;
    double radius;

    bool IsNear(const Ray& ray, double width, double widening) const;
  };
  struct Posed {
    Solid solid;
    Bounds bounds;             // around the shape's center
    Eigen::Matrix3d rotation;  // from the shape's frame to that of the world
    // What the link is about: all points within `radius` of a box with these half extents.
    Eigen::Vector3d core;
    double radius;
  };
  static Ray ToLink(const Posed& link, const Ray& ray);
  static double Hidden(const Posed& link, const Eigen::Vector3d& place,
                       const Eigen::Vector3d& normal);

  std::vector<Posed> links_;
  Bounds whole_{Eigen::Vector3d::Zero(), 0};
};

}  // namespace runtime
