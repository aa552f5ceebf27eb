// The floor of a picture: a faint disc with a grid of 10 cm, stronger lines each 50 cm, and the way
// that the robot has come, with a dot where it was at each picture of the strip so far.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "runtime/analysis/behavior/motion.h"
#include "runtime/analysis/picture/camera.h"
#include "runtime/analysis/picture/color.h"

namespace runtime {

using Point = Eigen::Vector2d;  // of the floor [m]

// Where a link was above the floor up to a frame, its swaying smoothed; and which of these places
// belong to pictures.
struct Trail {
  std::vector<Point> points;
  std::vector<Point> marks;
};

// Of a link, up to frames[picture].
Trail TrailOf(const Motion& motion, int link, const std::vector<int>& frames, size_t picture);

class Ground {
 public:
  Ground(const Camera& camera, const Trail& trail);

  // What the floor looks like in a pixel that covers the parallelogram with the sides `du` and `dv`
  // around `place` [m].
  Layer Look(const Point& place, const Point& du, const Point& dv) const;
  // How visible the floor is there: 1 in the middle, 0 from the edge of the disc on.
  double Presence(const Point& place) const;

 private:
  double TrailCover(const Point& place, double blur) const;

  Point middle_;
  double radius_;
  double line_;  // width of a line [m]
  Trail trail_;  // what of it is on the disc
};

}  // namespace runtime
