// A recorded motion as a film: picture after picture, as the camera goes along with the robot.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "plugins/world/world_description.h"
#include "runtime/analysis/behavior/motion.h"
#include "runtime/analysis/picture/camera.h"
#include "runtime/analysis/picture/image.h"
#include "runtime/analysis/picture/surface.h"
#include "runtime/analysis/picture/terrain.h"

namespace runtime {

struct FilmOptions {
  int size = 480;    // width and height [px], even
  double speed = 1;  // of the motion, as shown: 0.5 is half as fast as it was
  // The part of the motion that is shown [s]; what lies outside of the motion is left out.
  double from = 0;
  double to = std::numeric_limits<double>::infinity();
  // So many of the links, at the end, are things of the world: none of the robot's.
  size_t things = 0;
  world::Ground ground{};  // what all stand on
};

class Film {
 public:
  static constexpr int kPicturesPerSecond = 25;

  // `links`: those of the motion, with their shapes; they outlive the film.
  Film(const Motion& motion, const std::vector<robot::Link>& links, const FilmOptions& options);

  int picture_count() const { return static_cast<int>(cameras_.size()); }

  // Calls `take` with each picture in their order, opaque, `size` pixels wide and high; several are
  // drawn at the same time. Equal motions have equal pixels on every machine, as those of
  // SnapshotStrip() have.
  void Draw(const std::function<void(const Image&)>& take) const;

 private:
  Image Picture(size_t index) const;

  Motion motion_;  // a frame for each picture
  const std::vector<robot::Link>& links_;
  std::vector<Paint> paints_;  // of the links
  Terrain terrain_;
  int size_;
  int followed_ = 0;  // link
  std::vector<Camera> cameras_;
};

}  // namespace runtime
