#pragma once

#include <span>
#include <vector>

#include "runtime/analysis/picture/camera.h"
#include "runtime/analysis/picture/ground.h"
#include "runtime/analysis/picture/image.h"
#include "runtime/analysis/picture/posed_robot.h"
#include "runtime/analysis/picture/strokes.h"
#include "runtime/analysis/picture/surface.h"
#include "runtime/analysis/picture/terrain.h"

namespace runtime {

// What is to be seen in a picture.
struct Scene {
  const std::vector<robot::Link>& links;
  const std::vector<Paint>& paints;  // of the links
  const PosedRobot& robot;
  const Terrain& terrain;
  const Ground& ground;  // what can be seen on it
  const Camera& camera;
  std::span<const Stroke> strokes{};  // over all of it
};

// Draws the scene into the square of `size` pixels whose upper left corner is at (left, 0).
void Render(const Scene& scene, int left, int size, Image& image);

}  // namespace runtime
